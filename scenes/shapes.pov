// The plain solids on a table: box, sphere, cylinder, cone, torus, and what cutting one with another gives.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.08 diffuse 0.8 specular 0.35 roughness 0.02 } }

camera { location <-1.5, 4.2, -9> look_at <0.1, 0.75, 0.2> angle 38 }
light_source { <-6, 9, -5> rgb <1.1, 1.05, 0.95> }
light_source { <8, 5, -6> rgb <0.20, 0.24, 0.32> shadowless }
background { rgb <0.12, 0.14, 0.18> }

plane { y, 0 pigment { rgb <0.62, 0.60, 0.55> } finish { specular 0 reflection { 0, 0.2 } } }

box { <-3.1, 0, 0.6>, <-1.9, 1.2, 1.8> pigment { rgb <0.75, 0.24, 0.16> } rotate 6*y }
sphere { <-0.5, 0.8, 1.5>, 0.8 pigment { rgb <0.92, 0.70, 0.22> } }
cylinder { <1.35, 0, 1.6>, <1.35, 1.7, 1.6>, 0.62 pigment { rgb <0.24, 0.45, 0.36> } }
cone { <3.1, 0, 1.2>, 0.8, <3.1, 1.9, 1.2>, 0 pigment { rgb <0.22, 0.36, 0.62> } }
torus { 0.62, 0.24 translate <-2.2, 0.24, -1.1> pigment { rgb <0.30, 0.55, 0.60> } }
difference {
  sphere { 0.72*y, 0.78 }
  cylinder { <-1, 0.72, 0>, <1, 0.72, 0>, 0.42 pigment { rgb <0.9, 0.85, 0.75> } }
  plane { y, 0 }
  rotate -35*y
  translate <-0.1, 0, -1.2>
  pigment { rgb <0.62, 0.34, 0.52> }
}
intersection {
  box { <-0.6, 0, -0.6>, <0.6, 1.2, 0.6> }
  sphere { 0.6*y, 0.78 }
  rotate 28*y
  translate <2.0, 0, -0.9>
  pigment { rgb <0.80, 0.47, 0.20> }
}
