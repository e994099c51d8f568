// Boxes around objects.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro Box(O) ShowV(min_extent(O)) ShowV(max_extent(O)) #end
#declare A = box { <1, 2, 3>, <4, 5, 6> } Box(A) #declare B = sphere { <1, 0, 0>, 2 } Box(B) #declare C = object { A scale 2 translate x } Box(C) #declare D = union { object { A } object { B } } Box(D) #declare E = cylinder { 0, y*2, 1 } Box(E) #declare F = torus { 2, 0.5 } Box(F) #declare G = cone { 0, 1, y, 0.5 } Box(G)
#declare H = intersection { box { 0, 2 } box { 1, 3 } } Box(H) #declare I = difference { box { 0, 2 } sphere { 0, 1 } } Box(I)

sphere { 0, 1 }
