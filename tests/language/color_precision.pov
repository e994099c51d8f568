// Colours are kept in single precision, vectors in double.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare C = rgb 0.1; #declare V = <0.1, 0.1, 0.1>; #declare W = <0.1, 0.2, 0.3, 0.4, 0.6>;
#debug concat(str(C.red, 0, 18), "\n", str(V.x, 0, 18), "\n", str(W.red, 0, 18), "\n", str(W.transmit, 0, 18), "\n")
#debug concat(str((C*3).green, 0, 18), "\n", str((C+V).blue, 0, 18), "\n")
#declare D = C*3; #debug concat(str(D.green, 0, 18), "\n")
#declare E = rgb 1/3; #debug concat(str(E.blue, 0, 18), " ", str(E.gray, 0, 18), "\n")
#declare L = array[1]{rgb 0.7} #debug concat(str(L[0].red, 0, 18), "\n")

sphere { 0, 1 }
