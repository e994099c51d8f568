// A bowl, fruit and a bottle on a wooden table before a granite wall: solid textures, bumps, highlights.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
#default { finish { ambient 0.08 diffuse 0.75 } }

camera { location <0.3, 2.3, -5.4> look_at <0, 0.75, 0> angle 42 }
light_source { <-6, 8, -5> rgb 0.95 }
light_source { <5, 4, -6> rgb 0.25 }

#declare Wood = texture {
  pigment {
    wood turbulence 0.06 octaves 4
    color_map { [0 rgb <0.52, 0.3, 0.14>] [0.6 rgb <0.43, 0.23, 0.1>] [1 rgb <0.3, 0.15, 0.06>] }
    scale 0.22 rotate <3, 84, 2>
  }
  finish { specular 0.15 roughness 0.04 reflection 0.05 }
}

box { <-6, -0.2, -3>, <6, 0, 2.2> texture { Wood } }
plane { -z, -3.5
  pigment { granite turbulence 0.3 color_map { [0 rgb <0.42, 0.44, 0.46>] [1 rgb <0.66, 0.65, 0.6>] } scale 1.4 }
}
plane { y, -2 pigment { rgb 0.2 } }

// The bowl.
difference {
  sphere { <0, 1.1, 0>, 1.1 }
  sphere { <0, 1.1, 0>, 1.03 }
  box { <-2, 0.85, -2>, <2, 3, 2> }
  pigment { marble turbulence 0.9 color_map { [0 rgb <0.85, 0.85, 0.9>] [0.85 rgb <0.7, 0.72, 0.8>] [1 rgb <0.2, 0.25, 0.5>] } scale 0.5 }
  finish { specular 0.5 roughness 0.01 reflection 0.08 }
}

#macro Fruit(Place, Size, Hue)
  sphere { Place, Size
    pigment { bozo turbulence 0.4 color_map { [0 rgb Hue] [0.7 rgb Hue * 0.85] [1 rgb Hue * 0.6 + <0.15, 0.12, 0>] } scale Size * 0.5 }
    normal { bumps 0.25 scale Size * 0.06 }
    finish { specular 0.4 roughness 0.02 }
  }
#end
Fruit(<-0.38, 0.75, -0.25>, 0.42, <0.85, 0.4, 0.05>)
Fruit(<0.42, 0.72, -0.2>, 0.4, <0.75, 0.1, 0.08>)
Fruit(<0.02, 0.78, 0.4>, 0.43, <0.9, 0.75, 0.15>)
Fruit(<0.05, 1.3, 0.02>, 0.36, <0.4, 0.62, 0.12>)
Fruit(<1.5, 0.33, -0.9>, 0.33, <0.8, 0.42, 0.06>)

// The bottle.
lathe {
  quadratic_spline 8, <0, 0>, <0.38, 0>, <0.42, 0.1>, <0.42, 1.3>, <0.36, 1.6>, <0.13, 1.95>, <0.12, 2.5>, <0.15, 2.6>
  pigment { rgb <0.05, 0.2, 0.09> }
  finish { specular 0.9 roughness 0.005 reflection 0.18 }
  translate <-1.75, 0, 0.5>
}
torus { 0.4, 0.09 translate <1.55, 0.09, 0.35>
  pigment { leopard color_map { [0 rgb <0.75, 0.6, 0.2>] [1 rgb <0.5, 0.35, 0.08>] } scale 0.05 }
  finish { specular 0.6 roughness 0.02 reflection 0.15 }
}
