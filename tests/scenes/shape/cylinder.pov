// Cylinders: capped, open, and lying along a slanted axis.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
cylinder { <-1.6, -1, 0.5>, <-1.6, 0.8, 0.5>, 0.5 pigment { rgb <0.7, 0.3, 0.6> } }
cylinder { <0, -1, 0>, <0, 0.5, 0>, 0.6 open pigment { rgb <0.4, 0.7, 0.7> } }
cylinder { <1, -0.6, 1>, <2, 0.9, -0.4>, 0.35 pigment { rgb <0.9, 0.7, 0.3> } }
