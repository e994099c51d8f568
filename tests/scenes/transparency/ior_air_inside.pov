// An object with a hollow texture: ior of the way in and the way out.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -6> look_at 0 angle 46 }
light_source { <4, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.3, 0.4> } }
plane { z, 6 pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.9, 0.6, 0.4>] } scale 1.5 } }
difference {
  sphere { 0, 1.1 }
  sphere { 0, 0.95 }
  pigment { rgbf <0.95, 0.98, 1, 0.95> }
  finish { ambient 0 diffuse 0.02 reflection { 0.02, 0.6 } }
  interior { ior 1.4 }
}
