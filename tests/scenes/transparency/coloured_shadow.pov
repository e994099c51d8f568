// Shadows through filters of two colours, one behind the other.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -6> look_at 0 angle 46 }
light_source { <4, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.3, 0.4> } }
plane { z, 6 pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.9, 0.6, 0.4>] } scale 1.5 } }
box { <-1.6, -1, -0.6>, <0.4, 0.6, -0.55> pigment { rgbf <1, 0.3, 0.2, 0.9> } }
box { <-0.6, -1, 0.2>, <1.6, 0.8, 0.25> pigment { rgbf <0.3, 0.5, 1, 0.9> } }
