// Functions made of transformations.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = function { transform { rotate 30*x translate <1, 2, 3> } } ShowV(A(1, 2, 3)) Show(A(1, 2, 3).y) #declare T = transform { scale <1, 2, 3> rotate <10, 20, 30> } #declare B = function { transform { T } } ShowV(B(1, 1, 1))
#declare C = function { transform { T inverse } } ShowV(C(B(1, 1, 1).x, B(1, 1, 1).y, B(1, 1, 1).z)) #declare D = function { transform { matrix <1, 2, 3, 4, 5, 6, 7, 8, 10, 11, 12, 13> } } ShowV(D(1, 2, 3)) #declare E = function { transform { scale 0.5 inverse } } ShowV(E(1, 2, 3))
#declare F = function { transform { rotate 30*x translate <1, 2, 3> inverse scale 2 } } ShowV(F(1, 2, 3)) #declare G = function(a) { A(a, 0, 0).x+B(0, a, 0).z } Show(G(2))

sphere { 0, 1 }
