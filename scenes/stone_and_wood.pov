// Marble, wood and granite made of noise: solid patterns that run right through a cut block.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.1 diffuse 0.75 specular 0.3 roughness 0.02 reflection { 0, 0.12 } } }

camera { location <0, 3.4, -8> look_at <0, 0.75, 0> angle 46 }
light_source { <-5, 9, -6> rgb 1.05 area_light 2*x, 2*z, 4, 4 adaptive 1 }
light_source { <8, 6, -4> rgb <0.15, 0.18, 0.25> shadowless }
plane { y, 0 pigment { rgb <0.30, 0.32, 0.33> } }
plane { z, 7 pigment { rgb <0.22, 0.24, 0.27> } }

#declare Block = difference {
  box { <-1, 0, -1>, <1, 1.9, 1> }
  box { <0, 0.95, -1.1>, <1.1, 2, 0> }
  cylinder { <-0.5, -1, -0.5>, <-0.5, 3, -0.5>, 0.3 }
}
object {
  Block
  pigment {
    marble turbulence 0.9 octaves 6 lambda 2.1
    color_map { [0 rgb <0.90, 0.89, 0.86>] [0.65 rgb <0.82, 0.81, 0.79>] [0.88 rgb <0.42, 0.45, 0.47>] [1 rgb <0.18, 0.21, 0.24>] }
    scale 0.8 rotate <0, 30, 40>
  }
  rotate 24*y translate -2.5*x
}
object {
  Block
  pigment {
    wood turbulence 0.05 octaves 4
    color_map { [0 rgb <0.72, 0.47, 0.25>] [0.6 rgb <0.58, 0.33, 0.15>] [0.85 rgb <0.40, 0.20, 0.08>] [1 rgb <0.70, 0.45, 0.24>] }
    scale 0.22 rotate <84, 8, 0> translate <0.7, 0, 0.9>
  }
  rotate 24*y
}
object {
  Block
  pigment {
    granite scale 0.45
    color_map { [0 rgb <0.10, 0.09, 0.10>] [0.35 rgb <0.50, 0.30, 0.26>] [0.6 rgb <0.72, 0.52, 0.46>] [0.85 rgb <0.85, 0.75, 0.70>] [1 rgb 0.15] }
  }
  rotate 24*y translate 2.5*x
}
