// Faces that coincide in a difference are kept apart by a hair, as an author would.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
difference {
  box { -1, 1 }
  box { <-0.6, -0.6, -1.001>, <0.6, 0.6, 1.001> }
  pigment { rgb <0.7, 0.7, 0.4> }
  rotate <15, 35, 0>
}
