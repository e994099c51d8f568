// Diffuse light between surfaces, with few rays: where samples lie hangs on the order in which tiles are traced.
#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 30 error_bound 0.6 recursion_limit 2 pretrace_end 0.02 } }
camera { location <0, 1.4, -4.4> look_at <0, 0.9, 0> angle 55 }
background { rgb <0.6, 0.7, 0.9> }
light_source { <3, 6, -4> rgb <1.2, 1.1, 0.9> }
#default { finish { diffuse 0.8 } }
plane { y, 0 pigment { rgb 0.8 } }
box { <-2, 0, 1>, <2, 2, 1.3> pigment { rgb <0.9, 0.4, 0.3> } }
box { <-2, 2, -1>, <2, 2.2, 1.3> pigment { rgb 0.9 } }
sphere { <-0.8, 0.6, 0>, 0.6 pigment { rgb 0.9 } }
torus { 0.5, 0.2 rotate 60*x translate <0.8, 0.6, 0> pigment { rgb <0.5, 0.6, 0.9> } }
