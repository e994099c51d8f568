// A recursion of 30 and a bailout that ends it sooner: the same to the eye.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
global_settings { max_trace_level 30 adc_bailout 1/1000 }
box { <-1.5, -1, 1>, <1.5, 1, 1.1> pigment { rgb 0 } finish { reflection 0.5 ambient 0 diffuse 0 } }
sphere { <0, -0.3, 0>, 0.6 pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
