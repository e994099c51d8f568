// conserve_energy takes from transparency what reflection gives.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
sphere { <-1.2, 0, 0>, 1 pigment { rgbt <1, 1, 1, 0.9> } finish { reflection { 0.1, 1 } } }
sphere { <1.2, 0, 0>, 1 pigment { rgbt <1, 1, 1, 0.9> } finish { reflection { 0.1, 1 } conserve_energy } }
