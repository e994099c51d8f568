// Refraction: a lens, a ball and a rod of glass over squared paper.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }

camera { location <0, 5.5, -5> look_at <0, 0.2, 0> angle 42 }
light_source { <-5, 9, -2> rgb 1.05 }

plane {
  y, 0
  pigment { gradient x color_map { [0.06 rgb <0.15, 0.30, 0.65>] [0.06 rgbt 1] } scale 0.35 }
  finish { ambient 0.25 diffuse 0.7 }
}
plane { y, -0.001
  pigment { gradient z color_map { [0.06 rgb <0.15, 0.30, 0.65>] [0.06 rgb <0.93, 0.91, 0.84>] } scale 0.35 }
  finish { ambient 0.25 diffuse 0.7 }
}
#declare Glass = material {
  texture { pigment { rgbf <0.97, 1, 0.98, 0.97> } finish { ambient 0 diffuse 0 specular 0.9 roughness 0.002 reflection { 0.02, 0.8 fresnel } conserve_energy } }
  interior { ior 1.5 }
}
union {
  intersection { sphere { -1.5*y, 1.9 } sphere { 1.5*y, 1.9 } material { Glass } }
  torus { 1.18, 0.09 pigment { rgb <0.55, 0.40, 0.18> } finish { specular 0.8 roughness 0.02 metallic reflection 0.2 } }
  cylinder { 1.25*x, 2.9*x, 0.11 pigment { rgb <0.20, 0.09, 0.05> } finish { specular 0.6 roughness 0.02 } }
  rotate <0, 28, 0>
  translate <-0.9, 0.95, 0.35>
}
sphere { <1.75, 0.55, 0.85>, 0.55 material { Glass } }
cylinder { <0.4, 0.2, -1.5>, <2.5, 0.2, -0.7>, 0.2 material { Glass } }
