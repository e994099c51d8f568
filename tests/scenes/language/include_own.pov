// #include of a file beside the scene, with locals of its own.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#include "language_part.inc"
object { Part translate -0.9*x }
object { Part scale 0.6 rotate 40*z translate 1.2*x }
