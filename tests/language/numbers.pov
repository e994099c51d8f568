// Ways to write a number.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(5) Show(5.) Show(.5) Show(1e2) Show(1E2) Show(1e+2) Show(1e-2) Show(0.5e1) Show(.5e-1) Show(007) Show(1.e3) Show(123456789.123) Show(0)
Show(1e308*10) Show(3.14159265358979323846) Show((2e-308 > 0))

sphere { 0, 1 }
