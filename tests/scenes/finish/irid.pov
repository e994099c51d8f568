// Thin films: iridescence of three thicknesses.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
sphere { <-2.1, 0, 0>, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { irid { 0.4 thickness 0.2 turbulence 0 } } }
sphere { 0, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { irid { 0.4 thickness 0.6 turbulence 0 } } }
sphere { <2.1, 0, 0>, 0.95 pigment { rgb <0.8, 0.4, 0.2> } finish { irid { 0.6 thickness 1 turbulence 0.3 } } }
