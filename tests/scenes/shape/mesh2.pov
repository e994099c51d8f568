// mesh2 with normals of its own, smooth across an edge.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
mesh2 {
  vertex_vectors { 6, <-1.5, -0.9, 0.5>, <0, -0.9, -0.5>, <1.5, -0.9, 0.5>, <-1.5, 0.9, 0.5>, <0, 0.9, -0.5>, <1.5, 0.9, 0.5> }
  normal_vectors { 6, <-0.8, 0, -1>, <0, 0, -1>, <0.8, 0, -1>, <-0.8, 0.4, -1>, <0, 0.4, -1>, <0.8, 0.4, -1> }
  face_indices { 4, <0, 1, 4>, <0, 4, 3>, <1, 2, 5>, <1, 5, 4> }
  pigment { rgb <0.6, 0.6, 0.9> }
  finish { specular 0.6 roughness 0.02 }
}
