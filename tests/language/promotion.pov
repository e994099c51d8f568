// A number is replicated, a shorter vector is padded with 0.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare V = <1, 2, 3>;
ShowV(V+1) ShowV(1-V) ShowV(V*V) ShowV(V/2) ShowV(6/V) ShowV(<1, 2>+<1, 1, 1>) ShowV(<1, 2, 3>*<1, 2>) ShowV(x+2*y-z)
ShowC(<1, 2, 3, 4>+1) ShowC(<1, 2, 3, 4, 5>*2) ShowC(<1, 2>*<1, 2, 3, 4, 5>) ShowC(V+<0, 0, 0, 4, 5>) ShowC(V*<1, 1, 1, 1>)
Show(vlength(5)) Show(vdot(2, <1, 2, 3>)) ShowV(vcross(<1, 2>, z)) ShowV(vnormalize(3)) ShowV(vrotate(<1, 2>, 90*z))
Show((<1, 2, 3, 4>+0).t) Show((u+v).u) Show((u*3+v).v)

sphere { 0, 1 }
