// An inverse sphere in an intersection is a difference.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
intersection {
  box { -0.9, 0.9 }
  sphere { 0, 1.1 inverse pigment { rgb <0.9, 0.8, 0.3> } }
  pigment { rgb <0.5, 0.5, 0.8> }
  rotate <20, 30, 0>
}
