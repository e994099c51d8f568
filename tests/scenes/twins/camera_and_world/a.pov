// The camera moves and turns.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 rotate 30*y translate <0.5, 0.2, 0> }
light_source { <4, 6, -5> rgb 1 rotate 30*y translate <0.5, 0.2, 0> }
box { -0.8, 0.8 pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } rotate 30*y translate <0.5, 0.2, 0> }
