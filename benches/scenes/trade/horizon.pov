// A checkered plane that runs to the horizon, with a mirror ball and a glass ball.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#default { finish { ambient 0.1 diffuse 0.8 } }

camera { location <0, 1.4, -5.5> look_at <0, 0.9, 0> angle 55 }
light_source { <-12, 20, -14> rgb 1 }
background { rgb <0.45, 0.62, 0.86> }

plane { y, 0 pigment { checker rgb <0.9, 0.88, 0.82> rgb <0.12, 0.1, 0.14> } }
sphere { <-1.15, 1, 0.2>, 1 pigment { rgb 0.03 } finish { reflection 0.85 specular 0.6 roughness 0.004 } }
sphere {
  <1.15, 0.9, -0.4>, 0.9
  pigment { rgbt <0.97, 0.99, 0.98, 0.96> }
  finish { ambient 0 diffuse 0.05 reflection { 0.04, 1 fresnel on } conserve_energy specular 0.8 roughness 0.002 }
  interior { ior 1.5 }
}
