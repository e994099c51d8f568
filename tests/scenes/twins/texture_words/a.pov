// Texture statements in full.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
sphere { -x, 0.8 texture { pigment { color red 0.8 green 0.5 blue 0.3 } finish { phong 0.5 phong_size 40 } } }
sphere { x, 0.8 texture { pigment { checker pigment { color rgb <1, 1, 1> } pigment { color rgb <0.2, 0.2, 0.2> } scale 0.3 } } }
