// Three planes: a floor, a wall, and a slanting one; distances along unnormalised normals.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.3> } }
plane { <0, 0, 2>, 3 pigment { checker rgb <0.8, 0.7, 0.6>, rgb <0.6, 0.5, 0.5> } }
plane { <1, 1, 0>, -2.4 pigment { rgb <0.4, 0.5, 0.8> } }
