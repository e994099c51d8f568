// Interior fade: light lost in glass by distance, with a colour.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -6> look_at 0 angle 46 }
light_source { <4, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.3, 0.4> } }
plane { z, 6 pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.9, 0.6, 0.4>] } scale 1.5 } }
sphere { <-1.2, 0, 0>, 0.9 pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.3 fade_distance 0.5 fade_power 1 fade_color <0.2, 0.6, 0.3> } }
sphere { <1.2, 0, 0>, 0.9 pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.3 fade_distance 0.7 fade_power 1001 fade_color <0.6, 0.3, 0.2> } }
