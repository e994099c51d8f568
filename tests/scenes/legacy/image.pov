// An image in an old scene is taken raw.
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
box { <-1.6, -1, 0>, <1.6, 1.2, 0.1> pigment { image_map { png "card.png" interpolate 2 } scale <3.2, 2.2, 1> translate <-1.6, -1, 0> } finish { ambient 0.4 } }
