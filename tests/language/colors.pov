// The forms of a colour.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = rgb 0.5; ShowC(A)
#declare A = rgb <1, 2>; ShowC(A)
#declare A = rgbf 0.5; ShowC(A)
#declare A = rgbf <1, 2, 3>; ShowC(A)
#declare A = rgbt 0.5; ShowC(A)
#declare A = rgbt <1, 2, 3, 4>; ShowC(A)
#declare A = rgbft <1, 2, 3, 4, 5>; ShowC(A)
#declare A = color 0.5; ShowC(A)
#declare A = color <1, 2, 3>; ShowC(A)
#declare A = color red 1 green 0.5; ShowC(A)
#declare A = colour blue 1 transmit 0.3 red 0.2; ShowC(A)
#declare B = rgb <0.1, 0.2, 0.3>; #declare A = color B red 9; ShowC(A)
#declare A = color B filter 0.5; ShowC(A)
#declare A = rgb 1 filter 0.3; ShowC(A)
#declare A = B*0.5; ShowC(A)
#declare A = B+<1, 1, 1>; ShowC(A)
#declare A = color rgb B*2 transmit 0.1; ShowC(A)
#declare A = rgb 1<2; ShowC(A)
#declare A = rgb (1+2)*<1, 2, 3>; ShowC(A)

sphere { 0, 1 }
