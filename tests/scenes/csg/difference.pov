// Cut faces take the texture of what cuts.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
difference {
  box { -1, 1 pigment { rgb <0.7, 0.7, 0.7> } }
  sphere { <0.2, 0.9, -0.9>, 1 pigment { rgb <0.9, 0.3, 0.2> } }
  cylinder { -2*x, 2*x, 0.4 pigment { rgb <0.2, 0.5, 0.9> } }
  rotate 30*y
}
