// A lamp with a body that lets its own light out.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2, -6> look_at <0, -0.2, 0> angle 44 }
light_source { <0.1, 0.3, -1.2> rgb 1 fade_distance 2 fade_power 2 looks_like { sphere { 0, 0.25 pigment { rgb <1, 0.9, 0.5> } finish { emission 1 } } } }
light_source { <0, 6, -6> rgb 0.15 shadowless }
plane { y, -1 pigment { rgb 0.9 } }
plane { z, 4 pigment { rgb 0.9 } }
sphere { <-1, -0.2, 0>, 0.8 pigment { rgb <0.9, 0.7, 0.5> } }
box { <0.5, -1, 0>, <1.5, 0.5, 1> rotate 15*y pigment { rgb <0.5, 0.7, 0.9> } }
