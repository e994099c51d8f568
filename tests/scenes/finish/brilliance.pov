// brilliance narrows the lit part.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
sphere { <-2.1, 0, 0>, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { brilliance 0.5 } }
sphere { 0, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { brilliance 2.5 } }
sphere { <2.1, 0, 0>, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { brilliance 8 diffuse 0.9 } }
