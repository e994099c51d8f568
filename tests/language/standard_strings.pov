// strings.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#include "strings.inc"
ShowS(CRGBStr(<0.1, 0.2, 0.3>, 0, 3)) ShowS(Vstr(<1, 2, 3>, 0, 2)) ShowS(Vstr2D(<1, 2>, 0, 1)) ShowS(VStr(x+y)) ShowS(VStr2D(<3, 4>)) ShowS(Str(5)) ShowS(CRGBFTStr(rgbft <1, 2, 3, 4, 5>, 0, 1))
ShowS(substr(Triangle_Str(x, y, z), 1, 60)) Show(strlen(Triangle_Str(x, y, z))) 

sphere { 0, 1 }
