// An intersection with inverses.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
intersection { sphere { 0, 1.1 } cylinder { -2*z, 2*z, 0.4 inverse } box { <0, 0, -2>, <2, 2, 0> inverse } pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
