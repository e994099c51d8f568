// A colour that is left away is black, alone or behind `color`; a number may lack the digits of its exponent.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare C = color; ShowC(C) #declare C = colour red 1; ShowC(C) #declare C = color filter 0.5; ShowC(C)
#declare A = array[3] { color, color green 1, colour } ShowC(A[0]) ShowC(A[1]) ShowC(A[2])
#macro Both(P, Q) ShowC(P) ShowC(Q) #end Both(color, color) Both(color red 1 color) Both(color color)
#declare P = pigment { color } #declare F1 = function { pigment { P } } ShowC(F1(0, 0, 0))
#declare P = pigment { gradient x color_map { [0 color] [1 color rgb 1] } } #declare F2 = function { pigment { P } } ShowC(F2(0.25, 0, 0))
#declare P = pigment { gradient x color_map { [0 1 color rgb 1 color] } } #declare F3 = function { pigment { P } } ShowC(F3(0.25, 0, 0))
#declare P = pigment { checker color rgb 1 color } #declare F4 = function { pigment { P } } ShowC(F4(0.25, 0, 0)) ShowC(F4(1.25, 0, 0))
#declare P = pigment { checker color, color } #declare F5 = function { pigment { P } } ShowC(F5(0.25, 0, 0)) ShowC(F5(1.25, 0, 0))
// A map without a pattern waits for one.
#declare P = pigment { color_map { [0 rgb <1, 0.5, 0>] [1 rgb <0, 0, 1>] } } #declare F6 = function { pigment { P } } ShowC(F6(0.25, 0, 0))
#declare Q = pigment { P gradient x } #declare F7 = function { pigment { Q } } ShowC(F7(0.25, 0, 0))
#declare Q = pigment { P color_map { [0 rgb 1] [1 rgb 1] } } #declare F8 = function { pigment { Q } } ShowC(F8(0.25, 0, 0))
#declare Q = pigment { P rgb 0.5 } #declare F9 = function { pigment { Q } } ShowC(F9(0.25, 0, 0))
#declare P = pigment { pigment_map { [0 rgb <1, 0.5, 0>] [1 color] } } #declare F10 = function { pigment { P gradient x } } ShowC(F10(0.25, 0, 0))
#declare N = 1e; Show(N) #declare N = 2.5E*2; Show(N) #declare N = .5e+; Show(N) #declare N = 3e-*1e1; Show(N) #declare N = 1.e; Show(N)
#declare V = <1e, 2e+, 12345678901234567890123e>; Show(V.x) Show(V.y) Show(V.z/1e22)

sphere { 0, 1 pigment { color } finish { ambient emission reflection } }
