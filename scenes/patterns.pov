// Twelve patterns on twelve tiles.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.15 diffuse 0.75 specular 0.2 roughness 0.02 } }

camera { orthographic location <0, 0, -10> right 8.4*x up 6.3*y look_at 0 }
light_source { <-6, 9, -12> rgb 1 }
plane { z, 0.3 pigment { rgb <0.10, 0.11, 0.13> } }

#declare Map = color_map { [0 rgb <0.08, 0.10, 0.26>] [0.4 rgb <0.15, 0.42, 0.50>] [0.7 rgb <0.90, 0.72, 0.35>] [1 rgb <0.98, 0.95, 0.85>] }
#declare Paint = array[12] {
  pigment { agate agate_turb 0.8 color_map { Map } scale 0.7 },
  pigment { bozo color_map { Map } scale 0.18 },
  pigment { marble turbulence 0.7 color_map { Map } scale 0.5 rotate 30*z },
  pigment { granite color_map { Map } scale 0.9 },
  pigment { wood turbulence 0.12 color_map { Map } scale 0.3 rotate <80, 20, 0> translate 0.4 },
  pigment { leopard color_map { Map } scale 0.09 },
  pigment { spiral1 4 color_map { Map } scale 0.5 },
  pigment { radial frequency 8 triangle_wave color_map { Map } rotate 90*x },
  pigment { crackle color_map { Map } scale 0.25 },
  pigment { onion triangle_wave turbulence 0.2 color_map { Map } scale 0.4 },
  pigment { gradient <1, 1, 0> sine_wave color_map { Map } scale 0.45 },
  pigment { hexagon rgb <0.15, 0.42, 0.50>, rgb <0.90, 0.72, 0.35>, rgb <0.98, 0.95, 0.85> scale 0.22 rotate 90*x }
}
#for (I, 0, 11)
  intersection {
    box { <-0.92, -0.92, -0.2>, <0.92, 0.92, 0.2> }
    sphere { 0, 1.22 }
    pigment { Paint[I] }
    translate <-3 + 2*mod(I, 4), 2 - 2*div(I, 4), 0>
  }
#end
