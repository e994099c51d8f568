// Every ray ends on a surface that gives off exactly (0.5, 0.25, 0.125) and mirrors nothing: a picture of one colour.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0.3, 0.2, -0.4> look_at <1, 2, 3> angle 100 }
sphere { 0, 2 pigment { rgb <0.5, 0.25, 0.125> } finish { emission 1 ambient 0 diffuse 0 } }
