// Turbulence as a number and as a vector, with octaves, lambda, omega.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { gradient x turbulence 0.5 scale 0.6 color_map { [0 rgb 0.1] [1 rgb 1] } } finish { ambient 0.3 } }
sphere { 0, 1 pigment { gradient y turbulence <0.3, 0.9, 0> octaves 3 lambda 3 omega 0.7 scale 0.5 color_map { [0 rgb 0.2] [1 rgb 0.9] } } translate x finish { ambient 0.3 } }
