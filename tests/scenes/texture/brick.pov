// brick: size and mortar; the default one, small.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { brick rgb 0.8, rgb <0.6, 0.2, 0.15> brick_size <0.8, 0.3, 0.5> mortar 0.06 translate <0.1, 0.15, 0.2> } finish { ambient 0.3 } }
sphere { 0, 1 pigment { brick scale 0.08 } translate x finish { ambient 0.3 } }
