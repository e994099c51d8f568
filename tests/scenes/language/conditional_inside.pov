// #if within a vector, a colour and a block.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Tall = 1;
box { <-1, -1, -0.5>, <#if (Tall) -0.2, 0.9 #else 0.9, -0.2 #end, 0.5> pigment { rgb #ifdef (Tall) <0.9, 0.5, 0.2> #else 0.5 #end } }
sphere { <0.8, 0, 0>, 0.6 #ifndef (Nothing) scale <1, 1.3, 1> #end pigment { rgb <0.3, 0.6, 0.8> } }
