// bounded_by that is right changes nothing; clipped_by { bounded_by } clips.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
sphere { -1.1*x, 0.8 bounded_by { box { <-2, -1, -1>, <0, 1, 1> } } pigment { rgb <0.9, 0.4, 0.4> } }
sphere { 1.1*x, 0.9 bounded_by { box { <0, -0.5, -1>, <3, 0.5, 1> } } clipped_by { bounded_by } pigment { rgb <0.4, 0.5, 0.9> } }
