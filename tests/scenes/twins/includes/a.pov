// Text taken from an include.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#include "colors.inc"
#include "shapes.inc"
object { Round_Box(<-1, -1, -0.5>, <1, 0.6, 0.7>, 0.2, 0) pigment { SteelBlue } }
