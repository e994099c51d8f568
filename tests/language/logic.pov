// Truth is a magnitude above 1e-10.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show((1 & 1)) Show((1 & 0)) Show((0 | 0)) Show((0 | 2)) Show((-1 & 1)) Show((1e-11 | 0)) Show((1e-9 & 1)) Show((0.5 & 0.5))
ShowV((<1, 0, 1> & <1, 1, 0>)) ShowV((<0, 0, 1> | <0, 1, 0>)) ShowV((<1, 2, 3> & 1))
#if (1e-11) Show(1) #else Show(0) #end
#if (-1) Show(1) #else Show(0) #end
#if (1 & !0) Show(1) #end
#if ((2 > 1) | (1/1 > 2)) Show(2) #end
Show(true+yes+on) Show(false+no+off)

sphere { 0, 1 }
