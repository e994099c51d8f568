// Wedge of dark glass, ior 1, fade_power 1001, fade_distance 1, before a white wall: through a thickness d comes exp(-d).
// The wedge is 0 thick at x = -2 and 2 thick at x = 2.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y look_at 0 }
intersection {
  plane { -z, 2 }
  plane { <-1, 0, 2>, -2/sqrt(5) }
  plane { x, 3 }
  plane { -x, 3 }
  plane { y, 3 }
  plane { -y, 3 }
  pigment { rgbf 1 }
  finish { ambient 0 diffuse 0 }
  interior { fade_distance 1 fade_power 1001 fade_color 0 }
  translate 0.0*z
}
plane { -z, -4 pigment { rgb 1 } finish { emission 1 ambient 0 diffuse 0 } }
