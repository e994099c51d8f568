// uv_mapping on a sphere, a box, a torus and a cone-free triangle mesh.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
#declare Paint = pigment { gradient x color_map { [0 rgb <0.9, 0.2, 0.2>] [1 rgb <0.2, 0.2, 0.9>] } }
sphere { <-2.1, 0, 0>, 0.9 uv_mapping pigment { checker rgb 0.9, rgb <0.2, 0.5, 0.3> scale <0.125, 0.25, 1> } }
box { -0.65, 0.65 uv_mapping pigment { Paint } rotate <-25, 35, 0> }
torus { 0.6, 0.3 rotate -50*x translate 2.1*x uv_mapping pigment { checker rgb 0.9, rgb <0.6, 0.3, 0.5> scale <0.1, 0.25, 1> } }
