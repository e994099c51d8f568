// Rounded things from shapes.inc.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#include "shapes.inc"
object { Round_Box(<-2.1, -1, -0.4>, <-1, 0.3, 0.6>, 0.2, 0) pigment { rgb <0.9, 0.5, 0.3> } }
object { Round_Cylinder(<0, -1, 0>, <0, 0.5, 0>, 0.5, 0.15, 1) pigment { rgb <0.5, 0.8, 0.4> } }
object { Round_Cone2(<1.4, -0.5, 0>, 0.5, <1.9, 0.6, 0.3>, 0.2, 1) pigment { rgb <0.4, 0.5, 0.9> } }
object { Wire_Box(<-0.5, 0.7, -0.5>, <0.5, 1.3, 0.5>, 0.06, 0) pigment { rgb 0.8 } }
