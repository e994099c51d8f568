// Transformations by name, composed, inverted; the include's own.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#include "transforms.inc"
#declare Lift = transform { rotate 30*z translate <-1.5, 0.2, 0> }
box { <-0.3, -0.5, -0.3>, <0.3, 0.5, 0.3> transform Lift pigment { rgb <0.9, 0.4, 0.3> } }
box { <-0.3, -0.5, -0.3>, <0.3, 0.5, 0.3> transform { Lift inverse } scale 0.7 translate <-1.3, 0.3, 0> pigment { rgb <0.4, 0.8, 0.3> } }
cone { 0, 0.3, y, 0 Point_At_Trans(<1, 1, -1>) translate <1, -0.5, 0> pigment { rgb <0.3, 0.4, 0.9> } }
sphere { vtransform(<1.5, 0, 0>, transform { rotate 40*z }) + 0.6*x, 0.25 pigment { rgb 0.8 } }
