// Commas are optional, expressions take what they can.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = 2 -1; Show(A)
#declare V = <1 -1, 2, 3>; ShowV(V)
#declare W = <1 2 3>; ShowV(W)
#declare B = <1 + 2 3 (4)>; ShowV(B)
#declare C = <2*3 4, -5>; ShowV(C)
Show(vdot(<1 2 3> <4 5 6>)) Show(max(1, 2, 3)) Show(atan2(1, 2)) ShowS(str(3 0 2)) ShowS(concat("a" "b" "c"))
#declare D = array[3]{1 2, 3} Show(D[0]+D[1]*10+D[2]*100)

sphere { 0, 1 }
