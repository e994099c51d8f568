// A unit sphere under parallel light from the eye: the value at distance r from the middle is sqrt(1 - r^2).
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y look_at 0 }
light_source { -100*z rgb 1 parallel point_at 0 }
sphere { 0, 1 pigment { rgb 1 } finish { ambient 0 diffuse 1 } }
