// Fog and a background with transmit in an old scene.
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker color rgb <0.8, 0.8, 0.7> color rgb <0.3, 0.4, 0.3> } }
sphere { <-1.2, 0, 0>, 0.9 pigment { color rgb <0.8, 0.3, 0.2> } finish { phong 0.7 } }
sphere { <1.2, 0, 0>, 0.9 pigment { rgbf <0.7, 0.8, 0.9, 0.7> } finish { reflection 0.2 } }
background { color rgbt <0.2, 0.3, 0.6, 0.4> }
fog { distance 9 color rgbt <0.7, 0.7, 0.8, 0.2> }
