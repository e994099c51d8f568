// gradient along a slanting direction; with a map that jumps.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { gradient <1, 1, 0> color_map { [0 rgb <0.2, 0.1, 0.4>] [1 rgb <1, 0.8, 0.4>] } scale 0.8 } finish { ambient 0.3 } }
sphere { 0, 1 pigment { gradient y color_map { [0 rgb 1] [0.5 rgb 1] [0.5 rgb <0.8, 0.1, 0.1>] [1 rgb <0.8, 0.1, 0.1>] } scale 0.35 } translate x finish { ambient 0.3 } }
