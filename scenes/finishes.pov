// Fifteen finishes on fifteen balls: matt to mirror, highlights broad to narrow, metal, film, glow.

#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 4.2, -9.4> look_at <0, 0.72, 0> angle 45 }
light_source { <-6, 9, -7> rgb 1.0 }
light_source { <8, 4, -5> rgb <0.22, 0.25, 0.32> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.75, 0.72, 0.68>] [0.5 rgb <0.30, 0.40, 0.58>] [1 rgb <0.10, 0.15, 0.3>] } } }
plane { y, 0 pigment { checker rgb <0.66, 0.63, 0.58>, rgb <0.34, 0.34, 0.36> scale 0.75 } finish { ambient 0.1 } }

#declare Coat = array[15] {
  finish { ambient 0.05 diffuse 0.9 },
  finish { ambient 0.05 diffuse 0.9 brilliance 3 },
  finish { ambient 0.05 diffuse 0.7 phong 0.4 phong_size 6 },
  finish { ambient 0.05 diffuse 0.7 phong 0.9 phong_size 60 },
  finish { ambient 0.05 diffuse 0.7 specular 1 roughness 0.002 },
  finish { ambient 0.05 diffuse 0.5 specular 0.8 roughness 0.05 metallic },
  finish { ambient 0.05 diffuse 0.35 specular 0.8 roughness 0.02 metallic reflection { 0.3 metallic } },
  finish { ambient 0.05 diffuse 0.15 specular 0.8 roughness 0.005 metallic reflection { 0.7 metallic } },
  finish { ambient 0.05 diffuse 0.6 specular 0.7 roughness 0.004 reflection { 0.02, 0.8 falloff 4 } },
  finish { ambient 0 diffuse 0.05 reflection 0.9 },
  finish { ambient 0.05 diffuse 0.5 irid { 0.5 thickness 0.5 turbulence 0.3 } specular 0.5 },
  finish { ambient 0.05 diffuse 0.4 reflection rgb <0.1, 0.3, 0.5> },
  finish { ambient 0.5 diffuse 0.5 },
  finish { ambient 0 diffuse 0.3 emission rgb <0.5, 0.25, 0.05> },
  finish { ambient 0.05 diffuse 0.4 specular 0.6 roughness 0.15 reflection { 0.3 exponent 0.7 } }
}
#for (I, 0, 14)
  sphere { <-2.8 + 1.4*mod(I, 5), 0.6, 1.7 - 1.5*div(I, 5)>, 0.6 pigment { rgb <0.78, 0.36 - 0.012*I, 0.14 + 0.02*I> } finish { Coat[I] } }
#end
