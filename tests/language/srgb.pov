// Colours as a screen has them.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = srgb <0.5, 0.2, 1>; ShowC(A)
#declare A = srgb 0.02; ShowC(A)
#declare A = srgbf <0.5, 0.5, 0.5, 0.3>; ShowC(A)
#declare A = srgbt <0.5, 0.5, 0.5, 0.3>; ShowC(A)
#declare A = srgbft <0.1, 0.9, 0.5, 0.3, 0.2>; ShowC(A)
#declare A = color srgb 1; ShowC(A)
#declare A = srgb <255, 128, 0>/255; ShowC(A)
#declare A = srgb <0.25, 0.5, 0.75> transmit 0.5; ShowC(A)

sphere { 0, 1 }
