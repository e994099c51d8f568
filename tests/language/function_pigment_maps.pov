// Colours between the entries of a map, to the last digit.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare F = function { pigment { gradient x color_map { [0 rgb <0.1, 0.2, 0.3>] [1 rgb <0.7, 0.8, 0.9>] } } }
#declare G = function { pigment { gradient x color_map { [0.13 rgbft <0.9, 0.3, 0.7, 0.1, 0.6>] [0.77 rgbt <0.2, 0.5, 0.1, 0.4>] } } }
#declare H = function { pigment { gradient x pigment_map { [0.1 rgb <0.1, 0.2, 0.3>] [0.9 rgb <0.7, 0.8, 0.9>] } } }
#for (I, 0, 1, 0.05)
  #debug concat(vstr(3, F(I, 0, 0), ", ", 0, 17), "\n")
  #debug concat(vstr(3, G(I, 0, 0), ", ", 0, 17), "\n")
  #debug concat(vstr(2, <G(I, 0, 0).filter, G(I, 0, 0).transmit>, ", ", 0, 17), "\n")
  #debug concat(vstr(3, H(I, 0, 0), ", ", 0, 17), "\n")
#end

sphere { 0, 1 }
