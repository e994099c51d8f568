// Map entries of the old kind, with two values and two colours.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { gradient x color_map { [0.0 0.4 color rgb <0.9, 0.2, 0.2> color rgb <0.9, 0.9, 0.2>] [0.4 1.0 color rgb <0.2, 0.3, 0.9> color rgb <0.2, 0.9, 0.4>] } } finish { ambient 0.3 } }
sphere { 0, 1 pigment { gradient y color_map { [0.0 0.3 color rgb 1 color rgb 1] [0.3 1.001 color rgb 0.2 color rgb 0.5] } scale 0.4 } translate x finish { ambient 0.3 } }
