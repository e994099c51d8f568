// Layers of glass in an old scene: opacity by the brightest component.
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
background { color rgb <0.3, 0.4, 0.6> }
sphere { 0, 1.2
  texture { pigment { color rgb <0.8, 0.7, 0.3> } }
  texture { pigment { checker color rgbf <0.9, 0.2, 0.2, 0.6> color rgbt <0.2, 0.9, 0.2, 0.5> scale 0.5 } }
}
