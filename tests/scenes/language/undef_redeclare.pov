// #undef, a change of type, and ifdef of array elements.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Thing = 5;
#declare Thing = sphere { -1.2*x, 0.6 }
#declare Slots = array[3]
#declare Slots[1] = 0.5;
#undef Missing
#declare Gone = 1;
#undef Gone
object { Thing pigment { rgb <0.8, 0.4, 0.4> } }
#for (I, 0, 2)
  #ifdef (Slots[I])
    box { -Slots[I], Slots[I] translate 0.4*x pigment { rgb <0.4, 0.8, 0.4> } }
  #else
    sphere { <1 + I*0.4, 0.9, 0>, 0.15 pigment { rgb 0.8 } }
  #end
#end
#ifndef (Gone)
  cone { <1.7, -1, 0>, 0.4, <1.7, 0.3, 0>, 0 pigment { rgb <0.4, 0.4, 0.8> } }
#end
