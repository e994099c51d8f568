// Functions made of pigments.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = function { pigment { gradient x color_map { [0 rgb <1, 0, 0>] [1 rgb <0, 0.5, 1>] } } } Show(A(0.25, 0, 0).red) Show(A(0.25, 0, 0).green) Show(A(0.25, 0, 0).blue) ShowC(A(0.75, 0, 0)) Show(A(0.5, 0, 0).gray)
#declare B = function { pigment { rgbft <0.1, 0.2, 0.3, 0.4, 0.5> } } ShowC(B(0, 0, 0)) Show(B(1, 2, 3).filter) Show(B(1, 2, 3).transmit) #declare C = function(a) { A(a, 0, 0).red*2+A(a, 0, 0).gray } Show(C(0.5)) #declare D = A(0.1, 0, 0); ShowC(D)
#declare E = function { pigment { checker rgb 1, rgb 0 } } Show(E(0.5, 0.5, 0.5).red) Show(E(1.5, 0.5, 0.5).red)

sphere { 0, 1 }
