// colors.inc and consts.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#include "colors.inc" #include "consts.inc"
ShowC(Red) ShowC(White) ShowC(Gray50) ShowC(Clear) ShowC(SteelBlue) ShowC(Flesh) ShowC(NewTan) ShowC(DarkSlateGray) ShowC(Quartz) ShowC(MidnightBlue) Show(Yellow.green) ShowV(o) Show(Crown_Glass_Ior) Show(Water_Ior)
#declare H = CRGB2HSL(rgb <0.2, 0.5, 0.7>); ShowV(H) #declare C = CHSL2RGB(H); ShowV(C) #declare V = CRGB2HSV(rgb <0.2, 0.5, 0.7>); ShowV(V) #declare W = CHSV2RGB(V); ShowV(W) #declare D = CH2RGB(120); ShowV(D)

sphere { 0, 1 }
