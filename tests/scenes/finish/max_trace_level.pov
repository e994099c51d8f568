// Two mirrors face to face; the recursion ends at level 4.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 4 }

camera { location <0, 1.4, -6> look_at <0, 0, 0> angle 45 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
box { <-2.5, -1, 1.5>, <2.5, 1.5, 1.6> pigment { rgb 0 } finish { reflection 0.9 ambient 0 diffuse 0 } }
box { <-2.5, -1, -3>, <2.5, 0.2, -2.9> pigment { rgb 0 } finish { reflection 0.9 ambient 0 diffuse 0 } }
sphere { <0.3, -0.5, -0.5>, 0.5 pigment { rgb <0.9, 0.5, 0.2> } }
