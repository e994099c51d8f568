// mesh2 with uv vectors and a pattern in uv space.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
mesh2 {
  vertex_vectors { 4, <-1.6, -0.9, -0.5>, <1.6, -0.9, 0.5>, <1.6, 1.1, 0.5>, <-1.6, 1.1, -0.5> }
  uv_vectors { 4, <0, 0>, <2, 0>, <2, 1>, <0, 1> }
  face_indices { 2, <0, 1, 2>, <0, 2, 3> }
  uv_mapping
  pigment { checker rgb <0.9, 0.7, 0.2>, rgb <0.2, 0.3, 0.6> scale 0.25 }
}
