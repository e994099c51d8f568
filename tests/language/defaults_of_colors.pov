// Colours of objects are found again through functions.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare P = pigment { rgb <0.2, 0.4, 0.6> } #declare F = function { pigment { P } } ShowC(F(0, 0, 0)) #default { pigment { rgb <0.5, 0, 0> } } #declare Q = pigment { } #declare G = function { pigment { Q } } ShowC(G(0, 0, 0))
#declare R = pigment { P transmit 0.5 } #declare H = function { pigment { R } } ShowC(H(0, 0, 0))

sphere { 0, 1 }
