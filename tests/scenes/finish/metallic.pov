// metallic tints highlights with the pigment, whole or in part.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
sphere { <-2.1, 0, 0>, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { phong 1 phong_size 20 metallic } }
sphere { 0, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { specular 1 roughness 0.05 metallic 0.5 } }
sphere { <2.1, 0, 0>, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { specular 1 roughness 0.05 } }
