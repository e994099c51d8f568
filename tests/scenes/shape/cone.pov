// Cones: pointed, truncated, open, and wider at the second end.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
cone { <-1.8, -1, 0.3>, 0.7, <-1.8, 0.9, 0.3>, 0 pigment { rgb <0.9, 0.5, 0.2> } }
cone { <0, -1, 0>, 0.8, <0, 0.3, 0>, 0.3 pigment { rgb <0.4, 0.5, 0.8> } }
cone { <1.7, -1, 0>, 0.2, <1.6, 0.7, 0.2>, 0.7 open pigment { rgb <0.5, 0.8, 0.4> } }
