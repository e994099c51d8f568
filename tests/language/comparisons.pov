// Equality allows for 1e-10, less and greater do not.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show((1 = 1+1e-11)) Show((1 < 1+1e-11)) Show((1 <= 1-1e-11)) Show((1 >= 1+1e-11)) Show((1 != 1+1e-11))
Show((1 = 1+1e-9)) Show((1 != 1+1e-9)) Show((1 > 1-1e-11)) Show((0 = -0)) Show((1e30 = 1e30)) Show((2 >= 2)) Show((2 <= 2))
ShowV((<1, 2, 3> = <1, 0, 3>)) ShowV((<1, 2, 3> > 2)) ShowV((<1, 2, 3> <= <3, 2, 1>)) ShowV((2 != <1, 2, 3>))
Show(sin(1<2)) Show(abs(2>1)) Show(("a" < "b")) Show(("b" <= "a")) Show(("same" = "same")) Show(("a" != "b")) Show(("ab" > "a"))

sphere { 0, 1 }
