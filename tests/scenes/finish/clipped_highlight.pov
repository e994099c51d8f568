// Colours above 1 are cut only when they are written.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
sphere { <-2.1, 0, 0>, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { diffuse 2 } }
sphere { 0, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { specular 3 roughness 0.1 } }
sphere { <2.1, 0, 0>, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { emission 1.5 reflection 0.5 } }
