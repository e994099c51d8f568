// The same as a mesh2.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
mesh2 { vertex_vectors { 4, <0, 1, 0>, <1, -0.7, -0.5>, <-1, -0.7, -0.5>, <0, -0.7, 1> } face_indices { 4, <0, 1, 2>, <0, 1, 3>, <0, 2, 3>, <1, 2, 3> } rotate 20*y pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
