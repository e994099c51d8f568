// Functions made of splines.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = function { spline { linear_spline 0, <0, 0, 0> 1, <1, 2, 3> 2, <4, 0, 1> } } ShowV(A(0.5)) Show(A(1.5).x) Show(A(1.5).z) #declare B = function(a) { A(a).y*2 } Show(B(0.75)) #declare S = spline { cubic_spline -1, 0 0, 1 1, 4 2, 9 3, 2 } #declare C = function { spline { S } } Show(C(0.5).x) Show(C(1.5).x)

sphere { 0, 1 }
