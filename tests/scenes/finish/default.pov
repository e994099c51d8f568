// #default changes what objects without a texture, and texture statements, start from.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
#default { pigment { rgb <0.3, 0.6, 0.3> } finish { ambient 0.2 phong 0.8 } }
sphere { <-2.1, 0, 0>, 0.95 }
#default { finish { phong 0 reflection 0.3 } }
sphere { 0, 0.95 pigment { rgb <0.8, 0.5, 0.3> } }
sphere { <2.1, 0, 0>, 0.95 texture { finish { diffuse 0.9 } } }
