// Named colours.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#include "colors.inc"
#declare Sky = rgb CHSV2RGB(<200, 0.7, 0.9>);
#declare Names = array[8] { Firebrick, Gold, ForestGreen, SteelBlue, Orchid, Wheat, Sky, Gray60 }
#for (I, 0, 7)
  sphere { <mod(I, 4)*1 - 1.5, 0.6 - div(I, 4)*1.1, 0>, 0.45 pigment { Names[I] } }
#end
