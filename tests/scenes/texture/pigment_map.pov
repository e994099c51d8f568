// pigment_map blends whole pigments.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { gradient y pigment_map { [0.2 checker rgb 0.9, rgb <0.2, 0.2, 0.6> scale 0.3 translate 0.01*z] [0.8 rgb <0.9, 0.6, 0.2>] } scale 3.01 translate -1.5*y } finish { ambient 0.3 } }
sphere { 0, 1 pigment { average pigment_map { [1 gradient x color_map { [0 rgb <1, 0, 0>] [1 rgb 1] } scale 0.5] [2 gradient y color_map { [0 rgb <0, 0, 1>] [1 rgb 1] } scale 0.5] } } translate x finish { ambient 0.3 } }
