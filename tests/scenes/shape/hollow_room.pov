// Seen from inside: a box for a room, a sphere for a lamp shade.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <2, 2, -3> rgb 0.9 }
box { <-4, -1.5, -6>, <4, 3, 4> pigment { checker rgb <0.9, 0.8, 0.7>, rgb <0.6, 0.5, 0.5> } }
sphere { <0.5, 0, 1>, 0.8 pigment { rgb <0.3, 0.5, 0.9> } }
