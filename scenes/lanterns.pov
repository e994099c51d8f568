// Lamps with bodies (looks_like) whose light fades with the square of the distance.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.02 diffuse 0.8 } }

camera { location <0, 2.4, -8.5> look_at <0, 1.3, 0> angle 42 }
background { rgb <0.010, 0.014, 0.035> }

#macro Lantern(Place, Glow)
  light_source {
    Place, Glow*2.2
    fade_distance 0.9 fade_power 2
    looks_like { sphere { 0, 0.26 scale <1, 1.15, 1> pigment { Glow } finish { emission 1.3 diffuse 0 ambient 0 } } }
  }
  union {
    torus { 0.16, 0.035 translate 0.28*y }
    torus { 0.16, 0.035 translate -0.28*y }
    cylinder { 0.3*y, (4.5 - Place.y)*y, 0.012 }
    pigment { rgb <0.25, 0.14, 0.07> }
    translate Place
  }
#end

Lantern(<-2.6, 2.3, 0.8>, rgb <1.0, 0.35, 0.12>)
Lantern(<-0.9, 1.6, -0.2>, rgb <1.0, 0.62, 0.18>)
Lantern(<0.9, 2.5, 0.5>, rgb <0.95, 0.25, 0.30>)
Lantern(<2.5, 1.8, -0.1>, rgb <0.70, 0.85, 0.35>)

plane { y, 0 pigment { checker rgb <0.60, 0.55, 0.48>, rgb <0.38, 0.34, 0.30> scale 0.9 } finish { reflection { 0.02, 0.35 } } }
plane { z, 3.2 pigment { brick rgb <0.45, 0.42, 0.38>, rgb <0.46, 0.24, 0.17> scale 0.14 translate 0.05*z } }
#for (I, -3, 3, 2)
  cylinder { <I, 0, 2.6>, <I, 3.8, 2.6>, 0.2 pigment { rgb <0.40, 0.12, 0.08> } }
#end
