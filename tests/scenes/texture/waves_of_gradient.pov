// The six wave forms of a pattern, from top to bottom, with frequency and phase.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, 1.0, 0>, <2, 1.5, 1> pigment { gradient x ramp_wave frequency 1.5 phase 0.1 color_map { [0 rgb 0] [1 rgb <1, 0.9, 0.7>] } } finish { ambient 1 diffuse 0 } }
box { <-2, 0.5, 0>, <2, 1.0, 1> pigment { gradient x triangle_wave frequency 1.5 phase 0.1 color_map { [0 rgb 0] [1 rgb <1, 0.9, 0.7>] } } finish { ambient 1 diffuse 0 } }
box { <-2, 0.0, 0>, <2, 0.5, 1> pigment { gradient x sine_wave frequency 1.5 phase 0.1 color_map { [0 rgb 0] [1 rgb <1, 0.9, 0.7>] } } finish { ambient 1 diffuse 0 } }
box { <-2, -0.5, 0>, <2, 0.0, 1> pigment { gradient x scallop_wave frequency 1.5 phase 0.1 color_map { [0 rgb 0] [1 rgb <1, 0.9, 0.7>] } } finish { ambient 1 diffuse 0 } }
box { <-2, -1.0, 0>, <2, -0.5, 1> pigment { gradient x cubic_wave frequency 1.5 phase 0.1 color_map { [0 rgb 0] [1 rgb <1, 0.9, 0.7>] } } finish { ambient 1 diffuse 0 } }
box { <-2, -1.5, 0>, <2, -1.0, 1> pigment { gradient x poly_wave 3 frequency 1.5 phase 0.1 color_map { [0 rgb 0] [1 rgb <1, 0.9, 0.7>] } } finish { ambient 1 diffuse 0 } }
