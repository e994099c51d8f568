// #version 3.1 turns filter of upper layers to transmit.
#version 3.1;

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
sphere { 0, 1.2
  texture { pigment { color rgb <0.8, 0.7, 0.3> } }
  texture { pigment { checker color rgbf <0.9, 0.2, 0.2, 0.6> color rgbt <0.2, 0.9, 0.2, 0.5> scale 0.5 } }
}
