// `#version 3.5`: layers over each other with colour maps.
#version 3.5;

camera { location <0, 1.5, -6> direction 1.6*z up y right 1.33*x look_at <0, 0.2, 0> }
light_source { <4, 6, -5> color rgb 1 }
light_source { <-5, 3, -4> color rgb <0.3, 0.3, 0.5> }
sphere { <-1.1, 0.2, 0>, 1.1
  texture { pigment { gradient x color_map { [0 color rgb <0.9, 0.8, 0.2>] [1 color rgb <0.2, 0.3, 0.9>] } scale 0.7 } finish { diffuse 0.8 } }
  texture { pigment { gradient y color_map { [0 color rgbf <1, 0.5, 0.5, 0.6>] [0.6 color rgbt <0.2, 0.9, 0.2, 0.8>] [1 color rgbf <1, 1, 1, 1>] } scale 0.6 } finish { phong 0.8 } }
}
box { <0.3, -0.9, -0.6>, <2, 1.1, 0.6>
  texture { pigment { checker color rgb <0.8, 0.3, 0.3> color rgb <0.9, 0.9, 0.8> scale 0.4 } }
  texture { pigment { color rgbft <0.5, 0.6, 1, 0.3, 0.4> } finish { specular 0.5 } }
}
plane { y, -1 pigment { color rgb <0.4, 0.45, 0.4> } }
