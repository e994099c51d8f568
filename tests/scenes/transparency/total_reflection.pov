// A prism that sends the light back: total internal reflection.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -6> look_at 0 angle 46 }
light_source { <4, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.3, 0.4> } }
plane { z, 6 pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.9, 0.6, 0.4>] } scale 1.5 } }
intersection {
  plane { y, 0 rotate 45*x } plane { -y, 0 rotate -45*x } plane { -z, 0.6 } plane { x, 1.2 } plane { -x, 1.2 }
  pigment { rgbf 0.97 } finish { ambient 0 diffuse 0 } interior { ior 1.6 } rotate <-90, 10, 0> translate <0, 0.5, -0.5>
}
sphere { <0.5, -0.6, -2>, 0.3 pigment { rgb <0.9, 0.6, 0.2> } }
