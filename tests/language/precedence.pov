// Operators from tight to loose.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(1+2*3) Show((1+2)*3) Show(8/4/2) Show(8/(4/2)) Show(1-2-3) Show(2*3+4*5)
Show(-2*3) Show(2*-3) Show(- -2) Show(-(1+2)) Show(+5) Show(!0) Show(!3) Show(!!3)
Show((1+1=2)) Show((1<2)+(2<1)) Show((3>2>1)) Show((1=1=1)) Show((2*3>5)) Show((1|0&0)) Show((0&1|1))
Show((1 ? 2 : 3)) Show((0 ? 2 : 0 ? 4 : 5)) Show((1 ? 0 ? 1 : 2 : 3)) Show((1+1>1 ? 10 : 20)+1)
Show(-2*-2+3) Show(2-3*4/6+1) Show((1 < 2 & 3 < 4)) Show((1 < 2 | 3 > 4 & 0))

sphere { 0, 1 }
