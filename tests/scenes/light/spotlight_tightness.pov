// tightness darkens a spotlight towards its edge.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2, -6> look_at <0, -0.2, 0> angle 44 }
light_source { <3, 6, -4> rgb 2 spotlight point_at 0 radius 20 falloff 24 tightness 30 }
plane { y, -1 pigment { rgb 0.9 } }
plane { z, 4 pigment { rgb 0.9 } }
sphere { <-1, -0.2, 0>, 0.8 pigment { rgb <0.9, 0.7, 0.5> } }
box { <0.5, -1, 0>, <1.5, 0.5, 1> rotate 15*y pigment { rgb <0.5, 0.7, 0.9> } }
