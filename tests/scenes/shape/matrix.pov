// A shear and a mirror image by matrix.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
box { -0.6, 0.6 matrix <1, 0, 0, 0.5, 1, 0, 0, 0, 1, -1.2, -0.2, 0> pigment { rgb <0.8, 0.5, 0.3> } }
cone { 0, 0.7, <0.5, 1.4, 0>, 0.1 matrix <-1, 0, 0, 0, 1, 0, 0, 0, 1, 1.6, -1, 0> pigment { rgb <0.4, 0.6, 0.9> } }
