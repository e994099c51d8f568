// interior_texture paints the inside of an open shell.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -6> look_at 0 angle 46 }
light_source { <4, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.3, 0.4> } }
plane { z, 6 pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.9, 0.6, 0.4>] } scale 1.5 } }
sphere { 0, 1.1 clipped_by { plane { <-0.3, 1, -0.8>, 0.2 } } texture { pigment { rgb <0.8, 0.3, 0.2> } } interior_texture { pigment { rgb <0.2, 0.4, 0.8> } finish { phong 0.6 } } }
