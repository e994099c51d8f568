// A sphere off the axis, and one squashed unequally and turned.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
sphere { <-1.1, 0.2, 0.5>, 0.9 pigment { rgb <0.8, 0.3, 0.2> } }
sphere { 0, 1 scale <0.5, 1.2, 0.8> rotate <20, 30, 40> translate <1.2, 0, 0> pigment { rgb <0.2, 0.5, 0.8> } }
