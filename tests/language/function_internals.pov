// Internal functions by number.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = function { internal(61) } Show(A(1, 2, 3, 1)) #declare B = function { internal(70) } Show(B(1, 2, 3, 2, 0.5)) #declare C = function { internal(76) } Show(C(0.1, 0.2, 0.3)) #declare D = function { internal(78) } Show(D(0.1, 0.2, 0.3, 1)) Show(D(0.1, 0.2, 0.3, 2)) Show(D(0.1, 0.2, 0.3, 3))
#declare E = function { internal(60) } Show(E(1, 2, 3, 0.1, 1, 1, 1)) #declare F = function { internal(57) } Show(F(1, 2, 3)) #declare G = function { A(x, y, z, 1)+F(x, y, z) } Show(G(0, 3, 4)) #declare H = function { internal(64) } Show(H(1, 0.2, 0.5, 1, 0.2, 2, 1, 0, 1))

sphere { 0, 1 }
