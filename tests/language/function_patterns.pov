// Functions made of patterns.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = function { pattern { gradient x } } Show(A(0.25, 0, 0)) Show(A(-0.25, 0, 0)) Show(A(1, 0, 0)) #declare B = function { pattern { checker } } Show(B(0.5, 0.5, 0.5)) Show(B(1.5, 0.5, 0.5))
#declare C = function { pattern { spherical scale 2 translate x } } Show(C(1, 0, 0)) Show(C(1, 1, 0)) #declare D = function { pattern { bozo } } Show(D(0.3, 0.7, 1.1)) #declare E = function { pattern { wood turbulence 0.1 } } Show(E(0.3, 0.7, 1.1))
#declare F = function { pattern { gradient y sine_wave frequency 2 phase 0.1 } } Show(F(0, 0.3, 0)) #declare G = function { pattern { crackle } } Show(G(0.2, 0.4, 0.6)) #declare H = function { pattern { radial } } Show(H(1, 0, 1)) #declare I = function { pattern { marble } } Show(I(0.3, 0, 0))
#declare J = function { pattern { granite } } Show(J(0.3, 0.7, 1.1)) #declare K = function { pattern { leopard } } Show(K(1, 2, 3)) #declare L = function { pattern { brick } } Show(L(1, 0.1, 3)) #declare M = function { pattern { agate } } Show(M(0.1, 0.2, 0.3)) #declare N = function { pattern { onion } } Show(N(1, 2, 3))

sphere { 0, 1 }
