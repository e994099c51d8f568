// Solids made of planes: a wedge and a cube with a corner off.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
intersection {
  plane { y, 0.5 } plane { -y, 0.9 } plane { x + z, 0.4 } plane { -x, 0.5 } plane { -z, 0.6 }
  translate -1.2*x
  pigment { rgb <0.7, 0.4, 0.3> }
}
difference {
  box { -0.8, 0.8 }
  plane { <1, -1, 1>, -0.7 inverse }
  rotate 100*y
  translate 1.2*x
  pigment { rgb <0.4, 0.7, 0.5> }
}
