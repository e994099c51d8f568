// merge leaves no walls inside: one drop of many spheres, beside the same spheres as a union.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 12 }

camera { location <0, 1.6, -8> look_at <0, 0.1, 0> angle 42 }
light_source { <-6, 9, -6> rgb 1.1 }
plane { y, -1.3 pigment { checker rgb <0.85, 0.83, 0.78>, rgb <0.22, 0.30, 0.38> scale 0.8 } finish { ambient 0.15 } }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.75, 0.80, 0.85>] [0.6 rgb <0.20, 0.35, 0.60>] } } }

#declare Water = material {
  texture { pigment { rgbf <0.96, 0.99, 1, 0.95> } finish { ambient 0 diffuse 0 specular 0.8 roughness 0.003 reflection { 0.02, 0.7 fresnel } conserve_energy } }
  interior { ior 1.2 }
}
#macro Drops()
  sphere { <0, 0, 0>, 0.75 }
  sphere { <0.65, 0.45, 0>, 0.5 }
  sphere { <-0.6, 0.5, -0.2>, 0.45 }
  sphere { <0.1, -0.65, -0.3>, 0.5 }
  sphere { <-0.75, -0.35, 0.1>, 0.4 }
  sphere { <0.15, 0.85, 0.1>, 0.35 }
#end
merge { Drops() material { Water } translate -1.55*x }
union { Drops() material { Water } translate 1.55*x }
