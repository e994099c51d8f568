// Inside functions & binds tighter than |, and comparisons are exact.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = function(a, b) { a|b&0 } Show(A(1, 1)) #declare B = function(a) { a = 1+1e-11 } Show(B(1)) #declare C = function(a) { -a*a } Show(C(3)) #declare D = function(a, b) { a--b } Show(D(5, 3))
#declare E = function(a) { 2 < a } Show(E(1)) Show(E(3)) #declare F = function(a, b) { (a < b)+(a <= b)*2+(a > b)*4+(a >= b)*8+(a = b)*16+(a != b)*32 } Show(F(1, 2)) Show(F(2, 2)) Show(F(3, 2))
#declare G = function(a) { 1/a } #declare H = function(a) { a/4*4 } Show(H(0.3)) #declare I = function(a) { a-1-1 } Show(I(5)) #declare J = function(a) { 24/a/2 } Show(J(3)) #declare K = function(a) { pow(a, 3)+pow(a, 0)+pow(2, a) } Show(K(3)) Show(G(4))

sphere { 0, 1 }
