// `#version 3.5`: media with the defaults of its version, which emits and absorbs.
#version 3.5;

camera { location <0, 1.5, -6> direction 1.6*z up y right 1.33*x look_at <0, 0.2, 0> }
light_source { <4, 6, -5> color rgb 1 }
light_source { <-5, 3, -4> color rgb <0.3, 0.3, 0.5> }
plane { y, -1 pigment { checker color rgb 0.7 color rgb 0.3 } }
sphere { <-1.2, 0.2, 0>, 1.1 pigment { color rgbt 1 } hollow interior { media { emission rgb <0.8, 0.4, 0.1> } } }
box { <0.3, -0.9, -0.7>, <1.9, 0.9, 0.7> pigment { color rgbt 1 } hollow interior { media { absorption rgb <0.3, 0.6, 0.9> } } }
