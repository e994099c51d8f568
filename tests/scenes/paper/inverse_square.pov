// A lamp at height 1 over a plane, fade_power 2, fade_distance 1: at distance r from its foot, with d^2 = 1 + r^2, the
// light is 2/(1 + d^2) and falls in with cosine 1/d.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y look_at 0 }
light_source { -z rgb 1 fade_distance 1 fade_power 2 }
plane { -z, 0 pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
