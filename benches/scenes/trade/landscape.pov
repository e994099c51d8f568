// A height field of hills with snow by height, water and haze.

#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 max_trace_level 5 }
#default { finish { ambient 0.12 diffuse 0.8 } }

camera { location <0, 1.35, -5.2> look_at <0, 0.45, 0> angle 50 }
light_source { <-30, 22, -12> rgb <1, 0.95, 0.85> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.75, 0.82, 0.92>] [0.6 rgb <0.25, 0.42, 0.75>] } } }
fog { distance 45 rgb <0.7, 0.78, 0.9> }

height_field {
  function 300, 300 { 0.3 * f_ridged_mf(x * 4 + 3.1, 0, y * 4 + 1.7, 0.8, 2.1, 7, 0.7, 1.6, 2) * (1.15 - 0.9 * y) + 0.02 }
  translate <-0.5, 0, -0.5>
  scale <9, 5, 9>
  pigment {
    gradient y turbulence 0.12
    color_map {
      [0.00 rgb <0.35, 0.32, 0.2>] [0.22 rgb <0.2, 0.33, 0.12>] [0.45 rgb <0.3, 0.34, 0.17>]
      [0.6 rgb <0.42, 0.38, 0.33>] [0.78 rgb <0.5, 0.48, 0.46>] [0.82 rgb <0.93, 0.94, 0.97>]
    }
    scale <1, 2.2, 1>
  }
}
plane { y, 0.3
  pigment { rgb <0.05, 0.13, 0.2> }
  normal { ripples 0.06 frequency 6 scale 0.8 }
  finish { ambient 0.05 diffuse 0.2 reflection 0.45 specular 0.6 roughness 0.01 }
}
