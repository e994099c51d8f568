// The conditional operator: both branches are read, one is taken.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = 5;
Show((A > 3 ? 1 : 0)) Show((A < 3 ? 1 : 0)) Show((A ? A*2 : A/2)) ShowV((A > 3 ? x : y)) ShowV((A < 3 ? x : <4, 5, 6>))
Show((A = 5 ? A = 4 ? 1 : 2 : 3)) Show(1 + (A > 3 ? 10 : 20)*2) Show(((A > 3 ? <1, 2, 3> : x)).y)
Show(sin(A > 3 ? 0 : 1)) #declare B = (A > 3 ? 7 : 8); Show(B)
#if (A > 3 ? 0 : 1) Show(1) #else Show(2) #end

sphere { 0, 1 }
