// `#version 3.5`: filter and transmit, refraction, shadows through colours.
#version 3.5;

camera { location <0, 1.5, -6> direction 1.6*z up y right 1.33*x look_at <0, 0.2, 0> }
light_source { <4, 6, -5> color rgb 1 }
light_source { <-5, 3, -4> color rgb <0.3, 0.3, 0.5> }
background { color rgbt <0.2, 0.3, 0.5, 0.4> }
plane { y, -1 pigment { checker color rgb 0.9 color rgb 0.3 } finish { ambient 0.2 } }
sphere { <-1.3, 0, 0>, 0.9 pigment { color rgbf <1, 0.6, 0.5, 0.8> } finish { phong 0.6 ambient 0.1 } interior { ior 1.3 } }
box { <0.4, -0.9, -0.8>, <2, 0.8, 0.6> pigment { color rgbft <0.4, 0.8, 0.6, 0.4, 0.3> } rotate 15*y }
