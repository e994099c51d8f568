// Functions of numbers.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare F = function(a, b) { a*b+1 } Show(F(2, 3)) Show(F(F(1, 1), 2)) #declare G = function { x+y*10+z*100 } Show(G(1, 2, 3)) #declare H = function(x) { sin(x) } Show(H(1))
#declare K = 3; #declare I = function(t1) { t1*K } Show(I(2)) #declare J = function(u, v) { u-v } Show(J(5, 3)) #declare L = function(a) { F(a, a)+G(a, 0, 0) } Show(L(2))
#declare M = function(a) { select(a, -1, 0, 1) } Show(M(-5)) Show(M(0)) Show(M(5)) #declare N = function(a, b) { min(a, b)*max(a, b)+mod(a, b)+div(a, b)+pow(a, 2)+atan2(a, b) } Show(N(7, 3))
#declare P = function(a) { abs(a)+ceil(a)+floor(a)+int(a)+sqrt(abs(a))+exp(a)+ln(3+a)+log(3+a)+radians(a)+degrees(a) } Show(P(1.5)) Show(P(-1.5))
#declare Q = function(a) { sinh(a)+cosh(a)+tanh(a)+asinh(a)+acosh(a+2)+atanh(a/4)+tan(a)+asin(a/3)+acos(a/3)+atan(a) } Show(Q(0.7)) Show(-F(1, 2)*2) ShowV(F(1, 1)*x)

sphere { 0, 1 }
