// mesh2 with a list of textures, one a face, and three blended on one face.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
mesh2 {
  vertex_vectors { 4, <-1.6, -0.9, 0>, <1.6, -0.9, 0>, <1.6, 1.1, 0>, <-1.6, 1.1, 0> }
  texture_list {
    3,
    texture { pigment { rgb <0.9, 0.2, 0.2> } }
    texture { pigment { rgb <0.2, 0.8, 0.2> } }
    texture { pigment { rgb <0.2, 0.3, 0.9> } }
  }
  face_indices { 2, <0, 1, 2>, 0, 1, 2, <0, 2, 3>, 1 }
}
