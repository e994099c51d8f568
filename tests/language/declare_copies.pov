// Assignments copy.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = 1; #declare B = A; #declare A = 2; Show(B) #declare S = "a"; #declare T = S; #declare S = "b"; ShowS(T)
#declare F = function(q) { q*A } #declare A = 100; Show(F(3)) #declare G = F; #undef F Show(G(3))
#declare O = sphere { 0, 1 } #declare P = object { O translate x } #declare O = box { 0, 1 } ShowV(max_extent(P)) ShowV(max_extent(O))
#declare L = array[2]{1, 2} #declare M = L; #declare L[0] = 50; Show(M[0]) #declare V = x; #declare W = V; #declare V = V*3; ShowV(W)

sphere { 0, 1 }
