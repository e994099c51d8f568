// sum and prod.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = function(n) { sum(i, 1, n, i) } Show(A(10)) Show(A(0)) #declare B = function(n) { prod(i, 1, n, i) } Show(B(5)) Show(B(0)) #declare C = function(n) { sum(i, 0.5, n, i*i) } Show(C(3))
#declare D = function(n, m) { sum(i, 1, n, sum(j, 1, m, i*j)) } Show(D(3, 4)) #declare E = function(q) { sum(i, 0, 10, pow(q, i)/prod(j, 1, i, j)) } Show(E(1)) #declare F = function(n) { sum(i, 1, n, 1/i) } Show(F(100))

sphere { 0, 1 }
