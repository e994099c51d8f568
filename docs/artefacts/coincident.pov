// A block with a cut whose upper face lies in the block's own: the later face is the one to see, all over.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -7> look_at <0, 0, 0> angle 36 }
light_source { <-6, 9, -8> rgb 1 }
background { rgb <0.3, 0.4, 0.5> }
difference {
  box { <-1.7, -1, -1.3>, <1.6, 0, 1.4> }
  box { <-1, -0.6, -0.7>, <1, 0, 0.8> pigment { rgb <0.2, 0.5, 0.9> } }
  pigment { rgb <0.9, 0.6, 0.2> }
  rotate <17, 31, 7>
}
