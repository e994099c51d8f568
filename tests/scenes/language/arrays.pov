// Arrays of colours, of objects, in two dimensions, sorted by hand.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Colours = array[3] { rgb <0.9, 0.3, 0.2>, rgb <0.3, 0.8, 0.3>, rgb <0.2, 0.4, 0.9> }
#declare Shapes = array[2] { sphere { 0, 0.3 }, box { -0.25, 0.25 rotate 30*y } }
#declare Heights = array[2][3] { { 0, 0.4, 0.2 }, { 0.8, 0.1, 0.6 } }
#declare I = 0;
#while (I < dimension_size(Heights, 1))
  #declare J = 0;
  #while (J < dimension_size(Heights, 2))
    object { Shapes[I] translate <J - 1, Heights[I][J] - 0.5, 1 - I> pigment { Colours[J] } }
    #declare J = J + 1;
  #end
  #declare I = I + 1;
#end
