// Signs and negation bind tighter than products.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = 3; #declare V = <1, -2, 3>;
Show(-A*A) Show(!A+1) Show(!(A+1)) Show(-!0) Show(!-1) Show(+-+A)
Show(-V.y) Show(-V.x*2) Show((-V).z) ShowV(-V) ShowV(!V) ShowV(!<1, 0, 2>) ShowV(+V) ShowV(-V*2) ShowV(- -V)

sphere { 0, 1 }
