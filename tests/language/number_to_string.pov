// How numbers are written.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

ShowS(str(3.14159, 0, 3)) ShowS(str(3.14159, 8, 3)) ShowS(str(3.14159, -8, 3)) ShowS(str(-3.14159, -9, 3)) ShowS(str(3, 0, -1)) ShowS(str(3, 0, 0)) ShowS(str(2.5, 0, 0)) ShowS(str(3.5, 0, 0))
ShowS(str(-0.4, 0, 0)) ShowS(str(1e10, 0, 2)) ShowS(str(123456789, 0, 0)) ShowS(str(0.1+0.2, 0, 17)) ShowS(str(1/3, 20, 10)) ShowS(str(1e-7, 0, 7)) ShowS(str(-1, 5, 0)) ShowS(str(-1, -5, 0))
ShowS(str(0.05, 0, 1)) ShowS(str(0.15, 0, 1)) ShowS(str(0.25, 0, 1)) ShowS(str(1e22, 0, 0)) ShowS(str(2/3, 0, 30))

sphere { 0, 1 }
