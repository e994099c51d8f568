// Method 1, depth 5, threshold 0.05.
//! options: -A=0.05 --aa-method 1 --aa-depth 5 --jitter off
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 1, rgb 0 } }
sphere { <-0.8, 0, 0>, 0.9 pigment { rgb <0.9, 0.3, 0.2> } finish { phong 1 phong_size 200 } }
torus { 0.7, 0.08 rotate -60*x translate <1.1, 0, -0.5> pigment { rgb <0.3, 0.7, 0.9> } }
