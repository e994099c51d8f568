// Old words: colour, two-value map entries, refraction and ior in finish.
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker colour rgb 0.9 colour rgb 0.4 } }
sphere { -1.2*x, 0.9 pigment { gradient y colour_map { [0.0 0.5 colour rgb <0.8, 0.2, 0.2> colour rgb <0.9, 0.9, 0.3>] [0.5 1.01 colour rgb <0.2, 0.3, 0.8> colour rgb 1] } scale 2 translate -y } }
sphere { 1.2*x, 0.9 pigment { colour rgbf <1, 1, 1, 0.9> } finish { refraction 1 ior 1.4 phong 1 } }
