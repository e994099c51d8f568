// A number is a vector of one component.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare Q = 3; Show(Q.x) Show(Q.u) Show(Q.red) Show(-Q.x) Show((1 + 2).x) Show(sin(1).u) Show(pi.red) Show(Q.x + Q.u*2)
#declare A = array[2]{11, 12} Show(A[1].x) Show(true.x) Show(clock.u) Show(strlen("abc").x) Show(vlength(<3, 4, 0>).x) Show(Q.gray) Show(A[0].gray)
#macro M(B) Show(B.x) Show(B.u*2) #end M(5) M(3 + 4) M(Q)
#declare F = function(x) { x*2 } Show(F(3).x) Show(max(1, 2).red)
#declare I = 0; #while (I.x < 3) Show(I.x + I.u*2) #declare I = I + 1; #end
#declare V = <5, 6>; Show(V.gray) Show(<1, 2, 3, 4>.gray) Show(<1, 2, 3, 4>.filter)

sphere { 0, 1 }
