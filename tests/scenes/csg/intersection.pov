// An intersection of unlike shapes; each face keeps the texture of its shape.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
intersection {
  box { -0.9, 0.9 pigment { rgb <0.9, 0.4, 0.3> } }
  sphere { 0, 1.15 pigment { rgb <0.3, 0.6, 0.9> } }
  cylinder { -2*x, 2*x, 0.95 pigment { rgb <0.9, 0.9, 0.4> } }
  rotate <20, 35, 0>
}
