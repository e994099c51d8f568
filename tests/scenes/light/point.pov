// Two point lights of different colours.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2, -6> look_at <0, -0.2, 0> angle 44 }
light_source { <-4, 5, -4> rgb <0.8, 0.3, 0.2> }
light_source { <5, 4, -3> rgb <0.2, 0.4, 0.8> }
plane { y, -1 pigment { rgb 0.9 } }
plane { z, 4 pigment { rgb 0.9 } }
sphere { <-1, -0.2, 0>, 0.8 pigment { rgb <0.9, 0.7, 0.5> } }
box { <0.5, -1, 0>, <1.5, 0.5, 1> rotate 15*y pigment { rgb <0.5, 0.7, 0.9> } }
