// A camera of #version 3.1: each item acts at once.
#version 3.1;

camera { location <1, 1.5, -5> direction 1.3*z up y right 1.33*x look_at <0, 0, 0> }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker color rgb <0.8, 0.8, 0.7> color rgb <0.3, 0.4, 0.3> } }
sphere { <-1.2, 0, 0>, 0.9 pigment { color rgb <0.8, 0.3, 0.2> } finish { phong 0.7 } }
sphere { <1.2, 0, 0>, 0.9 pigment { rgbf <0.7, 0.8, 0.9, 0.7> } finish { reflection 0.2 } }
