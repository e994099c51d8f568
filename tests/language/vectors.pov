// Functions of vectors.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = <1, 2, 3>; #declare B = <-2, 0.5, 4>; ShowV(vcross(A, B)) ShowV(vnormalize(A)) Show(vdot(A, B)) Show(vlength(A)) Show(vlength(<1, 2>)) ShowV(vrotate(A, <30, 40, 50>)) ShowV(vrotate(x, 90*z)) ShowV(vrotate(x, 90*y)) ShowV(vrotate(y, 90*x))
ShowV(vaxis_rotate(A, <1, 1, 1>, 40)) ShowV(vaxis_rotate(x, y, 90)) ShowV(vaxis_rotate(A, 5*z, -30)) ShowV(vturbulence(2, 0.5, 6, <0.1, 0.2, 0.3>)) ShowV(vturbulence(2, 0.5, 1, A)) ShowV(vturbulence(3, 0.3, 20, B))
ShowV(vnormalize(vcross(A, B))*vlength(B)) Show(vdot(vnormalize(A), vnormalize(A)))

sphere { 0, 1 }
