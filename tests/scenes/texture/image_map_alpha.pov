// Transparency from the picture, and given to a colour index.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
plane { z, 1 pigment { checker rgb 0.9, rgb 0.5 scale 0.25 translate 0.01*z } finish { ambient 0.5 } }
box { <-1.9, -1, 0>, <-0.1, 1, 0.01> pigment { image_map { png "leaf.png" interpolate 2 } scale <1.8, 2, 1> translate <-1.9, -1, 0> } finish { ambient 0.5 } }
box { <0.1, -1, 0>, <1.9, 1, 0.01> pigment { image_map { gif "flag.gif" transmit 1, 0.8 filter 2, 0.6 } scale <1.8, 2, 1> translate <0.1, -1, 0> } finish { ambient 0.5 } }
