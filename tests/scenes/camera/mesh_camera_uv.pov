// Baking: the picture shows a mesh's surface laid flat by its surface parameters, smooth normals.
#version 3.7;
global_settings { assumed_gamma 1 }

#declare Bowl = mesh2 {
  vertex_vectors { 4, <-3, -2, 0>, <3, -2, 0>, <-3, 2, 0.3>, <3, 2, 0> }
  normal_vectors { 4, <-0.2, -0.2, -1>, <0.2, -0.2, -1>, <-0.2, 0.2, -1>, <0.2, 0.2, -1> }
  uv_vectors { 4, <0.05, 0.1>, <0.95, 0.05>, <0.1, 0.9>, <0.9, 0.95> }
  face_indices { 2, <0, 1, 3>, <0, 3, 2> }
}
camera { mesh_camera { 1 3 mesh { Bowl scale <1, 1, 1.5> translate <0, 0.5, -4> } smooth } location -0.01*z direction -z }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.9, 0.8>, rgb <0.4, 0.5, 0.4> } }
box { <-1.5, -1, 0>, <-0.5, 0.6, 1> pigment { rgb <0.8, 0.3, 0.3> } }
sphere { <0.8, -0.2, 0.5>, 0.8 pigment { rgb <0.3, 0.4, 0.8> } }
cone { <0, -1, 2.5>, 0.8, <0, 1.5, 2.5>, 0 pigment { rgb <0.9, 0.8, 0.3> } }
