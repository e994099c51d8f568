// Least, greatest and chosen.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(min(3, 1, 2)) Show(max(3, 1, 2)) Show(min(5)) Show(max(-1, -2)) Show(min(1, -1e10, 4)) Show(max(1, 2, 3, 4, 5, 6))
Show(select(-1, 10, 20)) Show(select(0, 10, 20)) Show(select(1, 10, 20)) Show(select(-1, 10, 20, 30)) Show(select(0, 10, 20, 30)) Show(select(2, 10, 20, 30)) Show(select(1e-12, 1, 2, 3))
#declare I = -2; #while (I <= 2) Show(select(I, I*10, 0, I*100)) #declare I = I+1; #end

sphere { 0, 1 }
