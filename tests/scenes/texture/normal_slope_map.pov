// A slope map makes ridges; bump_size scales it.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { rgb 0.7 } normal { gradient x 0.8 slope_map { [0 <0, 1>] [0.5 <1, 1>] [0.5 <1, -1>] [1 <0, -1>] } scale 0.3 } finish { specular 0.5 roughness 0.05 } }
sphere { 0, 1 pigment { rgb 0.6 } normal { onion 0.6 slope_map { [0 <0.5, 1>] [0.25 <1, 0>] [0.5 <0.5, -1>] [0.75 <0, 0>] [1 <0.5, 1>] } scale 0.2 bump_size 1.5 } translate x finish { specular 0.5 roughness 0.05 } }
