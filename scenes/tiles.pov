// image_map: a painted tile repeated on walls and floor, smooth and sharp, and wrapped round a jar and a ball.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.12 diffuse 0.8 specular 0.25 roughness 0.015 } }

camera { location <1.2, 2.2, -6.4> look_at <0, 1.15, 0.6> angle 45 }
light_source { <-3, 6, -5> rgb 1.0 }

plane { y, 0 pigment { image_map { png "tile.png" interpolate 2 } rotate 90*x scale 1.0 translate 0.5*x } finish { reflection { 0, 0.25 } } }
plane { z, 3 pigment { image_map { png "tile.png" } scale 1.5 } }
plane { -x, 4 pigment { rgb <0.75, 0.72, 0.66> } }

sphere { <1.55, 0.8, 0.4>, 0.8 pigment { image_map { png "tile.png" map_type 1 interpolate 2 } scale 0.8 translate <1.55, 0.8, 0.4> } finish { reflection 0.06 } }
union {
  difference { cylinder { 0, 1.7*y, 0.62 } cylinder { 0.1*y, 1.8*y, 0.55 } }
  torus { 0.585, 0.06 translate 1.7*y pigment { rgb <0.10, 0.25, 0.50> } }
  torus { 0.60, 0.05 translate 0.04*y pigment { rgb <0.10, 0.25, 0.50> } }
  pigment { image_map { png "tile.png" map_type 2 interpolate 2 } scale <1, 1.7, 1> }
  translate <-0.9, 0, 0.8>
}
