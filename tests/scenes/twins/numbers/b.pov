// The same by arithmetic.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare A = 1.5;
sphere { <-A/3, pow(0.5, 2), sin(0)>, (A > 1 ? A/2 : 9) pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
box { <1/2, -1, -0.5>, <1/2, -1, -1/2> + x + y + z pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
