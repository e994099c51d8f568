// trace() and inside().
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare S = sphere { 0, 1 } #declare N = <0, 0, 0>; ShowV(trace(S, -5*z, z)) ShowV(trace(S, <0.5, 0, -5>, z, N)) ShowV(N) ShowV(trace(S, 5*y, x, N)) ShowV(N) ShowV(trace(S, <0, 0, 0>, x+y, N)) ShowV(N)
#declare B = union { box { -1, 1 translate 3*x } plane { y, -2 } } ShowV(trace(B, <3, 5, 0>, -y, N)) ShowV(N) ShowV(trace(B, <0, 5, 0>, -2*y, N)) ShowV(N) Show(inside(S, 0)) Show(inside(S, 2*x)) Show(inside(B, <3, 0, 0>)) Show(inside(B, <0, -3, 0>)) Show(inside(B, 0))
#declare D = difference { object { S } sphere { x, 1 } } Show(inside(D, -0.5*x)) Show(inside(D, 0.5*x)) ShowV(trace(D, 5*x, -x, N)) ShowV(N) #declare I = object { S inverse } Show(inside(I, 0)) #declare T = object { S scale <1, 2, 1> translate y } ShowV(trace(T, <0.3, 9, 0.2>, -y, N)) ShowV(N)

sphere { 0, 1 }
