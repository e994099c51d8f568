// double_illuminate: both sides of a surface are lit from either.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <0, 2, 4> rgb 1 }
plane { y, -1 pigment { rgb 0.7 } }
disc { <-1.2, 0.2, 0>, <0.3, 0, 1>, 1 pigment { rgb <0.9, 0.8, 0.4> } double_illuminate }
disc { <1.2, 0.2, 0>, <-0.3, 0, 1>, 1 pigment { rgb <0.9, 0.8, 0.4> } }
