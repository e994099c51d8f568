// fade_distance and fade_power 2.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2, -6> look_at <0, -0.2, 0> angle 44 }
light_source { <0, 1.6, -1> rgb 1.5 fade_distance 1.5 fade_power 2 }
plane { y, -1 pigment { rgb 0.9 } }
plane { z, 4 pigment { rgb 0.9 } }
sphere { <-1, -0.2, 0>, 0.8 pigment { rgb <0.9, 0.7, 0.5> } }
box { <0.5, -1, 0>, <1.5, 0.5, 1> rotate 15*y pigment { rgb <0.5, 0.7, 0.9> } }
