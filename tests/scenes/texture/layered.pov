// Three layers: the lowest opaque, the others let it through by filter and by transmit.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
sphere { 0, 1.3
  texture { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.3>] [1 rgb <0.9, 0.3, 0.1>] } scale 2.7 translate -1.35*y } }
  texture { pigment { gradient x scale 0.5 color_map { [0.5 rgbf <0.3, 0.5, 1, 0.8>] [0.5 rgbt <1, 1, 1, 1>] } } }
  texture { pigment { checker rgbt <0, 0, 0, 0.3>, rgbt 1 scale 0.35 } finish { phong 0.8 } }
}
