// A union with a bound around it.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
union { sphere { -0.6*x, 0.7 } sphere { 0.8*x, 0.5 } bounded_by { box { <-1.4, -0.8, -0.8>, <1.4, 0.8, 0.8> } } pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
