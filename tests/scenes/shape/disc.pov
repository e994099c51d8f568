// Discs: whole, with a hole, seen from the back.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
disc { <-1.2, 0, 0>, <0.5, 0.5, -1>, 0.9 pigment { rgb <0.9, 0.3, 0.3> } }
disc { <1, 0, 0>, <-0.5, 1, -0.6>, 1, 0.45 pigment { rgb <0.3, 0.7, 0.9> } }
disc { <0, -0.6, 0>, <0.1, -1, 0.3>, 0.6 pigment { rgb <0.6, 0.9, 0.3> } }
