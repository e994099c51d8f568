// normal_map: one normal here, another there; average of two.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { rgb 0.7 } normal { gradient y normal_map { [0.4 bumps 0.8 scale 0.1] [0.6 ripples 0.8 frequency 8] } scale 3.01 translate -1.5*y } finish { specular 0.5 roughness 0.05 } }
sphere { 0, 1 pigment { rgb 0.6 } normal { average normal_map { [1 bumps 1 scale 0.15] [1 gradient x 1 scale 0.2 sine_wave] } } translate x finish { specular 0.5 roughness 0.05 } }
