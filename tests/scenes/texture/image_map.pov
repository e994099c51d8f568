// An image once, repeated, and smoothed by interpolate 2.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
#declare Card = pigment { image_map { png "card.png" once } }
box { <-2, -1.5, 0>, <0, 0, 1> pigment { image_map { png "card.png" interpolate 2 } scale <2, 1.5, 1> translate <-2, -1.5, 0> } finish { ambient 1 diffuse 0 } }
box { 0, <2, 1.5, 1> pigment { image_map { png "card.png" } scale <0.5, 0.4, 1> } finish { ambient 1 diffuse 0 } }
box { <0, -1.5, 0>, <2, 0, 1> pigment { rgb 0.3 } }
box { <0.5, -1.2, -0.3>, <1.5, -0.3, -0.2> pigment { Card scale <0.8, 0.6, 1> translate <0.6, -1.1, 0> } finish { ambient 1 diffuse 0 } }
