// No `#version`, gamma 1.8: patterns of the noise generator that is the default.
global_settings { assumed_gamma 1.8 }

camera { location <0, 1.5, -6> direction 1.6*z up y right 1.33*x look_at <0, 0.2, 0> }
light_source { <4, 6, -5> color rgb 1 }
light_source { <-5, 3, -4> color rgb <0.3, 0.3, 0.5> }
plane { y, -1 pigment { bozo color_map { [0 color rgb <0.1, 0.2, 0.4>] [1 color rgb <0.9, 0.9, 0.7>] } scale 0.6 turbulence 0.4 } }
sphere { <-1.3, 0.1, 0>, 1 pigment { marble turbulence 0.5 color_map { [0 color rgb <0.9, 0.7, 0.6>] [1 color rgb <0.3, 0.1, 0.1>] } scale 0.6 } finish { phong 0.4 } }
sphere { <1.3, 0.1, 0>, 1 pigment { wood turbulence 0.06 scale 0.3 color_map { [0 color rgb <0.7, 0.5, 0.3>] [1 color rgb <0.3, 0.2, 0.1>] } } normal { bumps 0.4 scale 0.4 } }
