// A sky sphere of two layers in an old scene.
camera { location <0, 0, -5> look_at <0, 1, 0> angle 70 }
light_source { <4, 6, -5> rgb 1 }
sky_sphere {
  pigment { gradient y color_map { [0.0 color rgb <0.9, 0.8, 0.6>] [0.6 color rgb <0.2, 0.3, 0.8>] } }
  pigment { bozo turbulence 0.5 color_map { [0.0 color rgbf 1] [0.4 color rgbf 1] [1.0 color rgbt <1, 1, 1, 0.2>] } scale 0.3 }
}
plane { y, -1 pigment { color rgb <0.3, 0.4, 0.2> } }
