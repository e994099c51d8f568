// Splines of numbers, of few knots, merged.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = spline { 0, 5 } Show(A(3).x) Show(A(-3).y) #declare B = spline { linear_spline 0, 1 2, 5 } Show(B(1).x) Show(B(1).y) #declare C = spline { 0, <1, 2> 1, <3, 4> } Show(C(0.5).u) Show(C(0.5).v)
#declare D = spline { linear_spline 1, x 0, y 0.5, z } ShowV(D(0.25)) ShowV(D(0.75)) #declare E = spline { D 0.25, <5, 5, 5> } ShowV(E(0.25)) ShowV(E(0.5)) #declare F = spline { linear_spline 0, 1 1, 2 1, 9 } Show(F(1).x)
#declare G = spline { cubic_spline 0, 1 1, 3 } Show(G(0.2).x) #declare H = spline { cubic_spline 0, 1 1, 3 2, 4 } Show(H(1.2).x) #declare I = spline { natural_spline 0, 1 1, 3 } Show(I(0.2).x) #declare J = spline { 0, <1, 2, 3, 4> 1, <5, 6, 7, 8> } Show(J(0.5).t)
#declare K = spline { 0, <1, 2, 3, 4, 5> 1, <5, 6, 7, 8, 9> } ShowC(K(0.25)) #declare T = 0.4; Show(K(T).x*2+1)

sphere { 0, 1 }
