// No `#version`, gamma 1.8: sky, fog and background together.
global_settings { assumed_gamma 1.8 }

camera { location <0, 1.5, -6> direction 1.6*z up y right 1.33*x look_at <0, 0.2, 0> }
light_source { <4, 6, -5> color rgb 1 }
light_source { <-5, 3, -4> color rgb <0.3, 0.3, 0.5> }
background { color rgb <0.5, 0.2, 0.2> }
sky_sphere { pigment { gradient y color_map { [0 color rgb <0.9, 0.8, 0.7>] [0.6 color rgbt <0.2, 0.3, 0.8, 0.4>] } } pigment { gradient x color_map { [0 color rgbt 1] [1 color rgbt <1, 0.6, 0.2, 0.6>] } scale 0.5 translate -0.5 } }
fog { color rgbt <0.6, 0.65, 0.7, 0.2> distance 25 }
plane { y, -1 pigment { checker color rgb 0.8 color rgb 0.4 } finish { reflection 0.2 } }
cylinder { <-1, -1, 0>, <-1, 1.2, 0>, 0.5 pigment { color rgb <0.8, 0.5, 0.2> } }
cone { <1.3, -1, 1>, 0.9, <1.3, 1.5, 1>, 0.1 pigment { color rgb <0.3, 0.6, 0.4> } finish { reflection 0.3 phong 0.5 } }
