// no_image hides from the eye, no_reflection from mirrors.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2, -6> look_at <0, -0.2, 0> angle 44 }
light_source { <-4, 5, -4> rgb 1 }
plane { y, -1 pigment { rgb 0.9 } finish { reflection 0.4 } }
sphere { <-1.2, -0.2, 0>, 0.8 pigment { rgb <0.9, 0.5, 0.3> } no_image }
sphere { <1.2, -0.2, 0>, 0.8 pigment { rgb <0.4, 0.7, 0.9> } no_reflection }
