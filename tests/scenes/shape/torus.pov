// Tori: seen from above, edge on, and with a hole that has closed.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
torus { 0.8, 0.25 translate <-1.2, -0.4, 0> pigment { rgb <0.9, 0.4, 0.3> } }
torus { 0.6, 0.15 rotate 90*x translate <0.7, 0.5, 0.6> pigment { rgb <0.3, 0.6, 0.9> } }
torus { 0.3, 0.45 rotate <60, 0, 20> translate <1.6, -0.4, 0> pigment { rgb <0.5, 0.8, 0.4> } }
