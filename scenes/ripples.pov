// Bent normals: rings on water round three stones, with the moon behind.

#version 3.7;
global_settings { assumed_gamma 1 number_of_waves 3 }

camera { location <0, 2.6, -8> look_at <0, 0.8, 0> angle 46 }
light_source { <6, 7, 30> rgb <0.85, 0.90, 1.0> }
light_source { <-10, 12, -10> rgb <0.14, 0.16, 0.22> }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.22, 0.26, 0.42>] [0.3 rgb <0.05, 0.07, 0.18>] [1 rgb <0.005, 0.01, 0.04>] } }
}
sphere { <7.5, 10.5, 40>, 2.6 pigment { bozo scale 0.9 turbulence 0.5 color_map { [0 rgb <0.80, 0.78, 0.70>] [1 rgb <1, 0.98, 0.9>] } } finish { emission 0.9 diffuse 0 ambient 0 } no_shadow }

plane {
  y, 0
  pigment { rgb <0.005, 0.02, 0.04> }
  normal { ripples 0.30 frequency 1.1 scale 1.7 translate <0.3, 0, 1.2> }
  finish { diffuse 0.4 specular 0.9 roughness 0.004 reflection { 0.08, 0.95 falloff 3 } }
}
#declare Pebble = sphere { 0, 1 pigment { granite scale 0.6 color_map { [0 rgb 0.10] [1 rgb <0.34, 0.32, 0.30>] } } normal { bumps 0.2 scale 0.08 } finish { specular 0.5 roughness 0.02 } }
object { Pebble scale <1.2, 0.5, 0.9> translate <-1.9, 0.12, 0.4> }
object { Pebble scale <0.8, 0.38, 0.6> rotate 30*y translate <0.7, 0.08, -1.0> }
object { Pebble scale <0.65, 0.3, 0.6> rotate 70*y translate <2.4, 0.05, 1.4> }
