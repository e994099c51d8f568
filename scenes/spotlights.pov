// Three coloured spotlights on a stage; where they meet, white.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.02 diffuse 0.85 } }

camera { location <0, 3.2, -9.5> look_at <0, 1.1, 0> angle 42 }

light_source { <-4.5, 8, -5> rgb <0.95, 0.08, 0.06> spotlight point_at <-0.3, 0, 0.2> radius 13 falloff 17 tightness 2 }
light_source { <4.5, 8, -5> rgb <0.06, 0.12, 1.0> spotlight point_at <0.3, 0, 0.2> radius 13 falloff 17 tightness 2 }
light_source { <0, 9, -3> rgb <0.06, 0.80, 0.10> spotlight point_at <0, 0, 0.6> radius 12 falloff 16 tightness 2 }
light_source { <0, 6, -10> rgb 0.06 shadowless }

plane { y, 0 pigment { rgb 0.75 } finish { reflection { 0.01, 0.25 } } }
plane { z, 5 pigment { gradient x sine_wave color_map { [0 rgb <0.55, 0.5, 0.5>] [1 rgb <0.9, 0.85, 0.85>] } scale 0.8 } normal { gradient x 0.6 sine_wave scale 0.8 } }

union {
  cylinder { 0, 0.25*y, 1.3 }
  sphere { 1.35*y, 0.75 }
  cone { 0.25*y, 0.6, 0.8*y, 0.25 }
  torus { 1.1, 0.07 rotate <70, 0, 25> translate 1.35*y }
  pigment { rgb 0.95 }
  finish { specular 0.5 roughness 0.01 }
}
