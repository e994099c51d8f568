// Boxes: corners in any order, one turned about three axes.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
box { <-0.4, 0.9, 0.3>, <-1.9, -0.7, 1.1> pigment { rgb <0.8, 0.6, 0.2> } }
box { -0.7, 0.7 rotate <30, 40, 15> translate <1.1, 0, 0> pigment { rgb <0.3, 0.7, 0.4> } }
