// The camera stays, the world does not move.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
box { -0.8, 0.8 pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
