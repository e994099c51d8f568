// An area light: shadows sharp where things touch the ground, soft where they are far from it.

#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 5, -9> look_at <-0.3, 0.7, 0> angle 38 }
light_source {
  <5, 9, 11> rgb <1.15, 1.05, 0.9>
  area_light <2.2, 0, -1>, <0, 1.6, 0>, 8, 8 adaptive 2
}
light_source { <-6, 9, -8> rgb <0.12, 0.15, 0.2> shadowless }

plane { y, 0 pigment { rgb <0.85, 0.80, 0.72> } finish { ambient 0.06 diffuse 0.8 } }
#for (I, -3, 3)
  cylinder { <I, 0, 1.2>, <I, 2.2, 1.2>, 0.14 pigment { rgb <0.72, 0.36, 0.20> } finish { ambient 0.06 specular 0.3 } }
  sphere { <I, 2.3, 1.2>, 0.24 pigment { rgb <0.90, 0.68, 0.25> } finish { ambient 0.06 specular 0.7 roughness 0.02 } }
  box { <I - 0.28, 0, 0.92>, <I + 0.28, 0.14, 1.48> pigment { rgb <0.45, 0.42, 0.40> } finish { ambient 0.06 } }
#end
cylinder { <-3.6, 1.6, 1.2>, <3.6, 1.6, 1.2>, 0.06 pigment { rgb 0.3 } finish { ambient 0.06 } }
