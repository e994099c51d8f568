// clipped_by leaves an open shell; its inside is seen.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
sphere { -1.1*x, 0.95 clipped_by { plane { y, 0.3 } } pigment { rgb <0.9, 0.6, 0.3> } }
torus { 0.7, 0.3 clipped_by { box { <-2, -2, 0>, <2, 2, 2> } } rotate -40*x translate 1.2*x pigment { rgb <0.4, 0.7, 0.9> } }
