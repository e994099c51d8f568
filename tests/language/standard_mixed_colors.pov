#version 3.7;
global_settings { assumed_gamma 1 }
#include "colors.inc"
#debug concat(vstr(5,Clear,",",0,2), vstr(5,CRGB2HSL(Red),",",0,2), vstr(5,CHSV2RGB(<120,1,1>),",",0,2), "\n")
#declare K = color Red*0.5 + Blue filter 0.3;
#debug vstr(5,K,",",0,2) #debug "\n"
