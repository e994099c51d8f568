// How vectors are written.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

ShowS(vstr(3, <1, 2, 3>, ", ", 0, 1)) ShowS(vstr(2, <1, 2, 3>, "/", 0, 0)) ShowS(vstr(5, 1, " ", 0, 2)) ShowS(vstr(4, <1, 2>, ";", 3, 0)) ShowS(vstr(3, 7, ",", -4, 1)) ShowS(vstr(1, <1, 2>, ",", 0, 0))
ShowS(vstr(9, <1, 2, 3, 4, 5>, "", 0, 0)) ShowS(vstr(3, x+y, "--", 0, 3)) ShowS(vstr(3, -z, " ", 6, 2)) ShowS(vstr(3, <0.1, 0.25, 1e6>, ",", 0, -1))

sphere { 0, 1 }
