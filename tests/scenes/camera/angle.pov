// Perspective by angle, narrow.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <1, 2, -9> look_at <0, 0, 1> angle 22 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.9, 0.8>, rgb <0.4, 0.5, 0.4> } }
box { <-1.5, -1, 0>, <-0.5, 0.6, 1> pigment { rgb <0.8, 0.3, 0.3> } }
sphere { <0.8, -0.2, 0.5>, 0.8 pigment { rgb <0.3, 0.4, 0.8> } }
cone { <0, -1, 2.5>, 0.8, <0, 1.5, 2.5>, 0 pigment { rgb <0.9, 0.8, 0.3> } }
