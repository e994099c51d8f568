// Bent normals: ripples and waves, with frequency.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { rgb 0.7 } normal { ripples 0.5 frequency 6 } finish { specular 0.5 roughness 0.05 } }
sphere { 0, 1 pigment { rgb 0.6 } normal { waves 0.6 frequency 5 phase 0.3 } translate x finish { specular 0.5 roughness 0.05 } }
