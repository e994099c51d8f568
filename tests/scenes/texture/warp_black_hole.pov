// A black hole draws a pattern in; another pushes it out.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { checker rgb 0.9, rgb <0.2, 0.4, 0.6> scale 0.25 translate 0.01*z warp { black_hole <-1, 0, 0>, 0.8 strength 1.5 falloff 2 } } finish { ambient 0.3 } }
sphere { 0, 1 pigment { checker rgb 0.9, rgb <0.6, 0.4, 0.2> scale 0.2 warp { black_hole <0, 0, -1>, 0.7 inverse strength 1 } } translate x finish { ambient 0.3 } }
