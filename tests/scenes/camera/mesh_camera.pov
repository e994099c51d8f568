// A ray from each face of a mesh, two meshes for the mean; the start moved.
#version 3.7;
global_settings { assumed_gamma 1 }

// One triangle for each pixel of 160 x 120, on a bulging sheet.
#macro At(I, J) #local U = 0.04*(I - 80); #local V = 0.04*(60 - J); <U, V, 0.06*(U*U + V*V)> #end
#declare Sheet = mesh {
  #local J = 0; #while (J < 120) #local I = 0; #while (I < 160)
    triangle { At(I, J), At(I + 1, J), At(I, J + 1) }
  #local I = I + 1; #end #local J = J + 1; #end
}
camera {
  mesh_camera { 2 0 mesh { Sheet translate -5*z } mesh { Sheet scale <1.1, 1, 1> rotate 4*y translate -5*z } }
  location -0.01*z
}
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb <0.9, 0.9, 0.8>, rgb <0.4, 0.5, 0.4> } }
box { <-1.5, -1, 0>, <-0.5, 0.6, 1> pigment { rgb <0.8, 0.3, 0.3> } }
sphere { <0.8, -0.2, 0.5>, 0.8 pigment { rgb <0.3, 0.4, 0.8> } }
cone { <0, -1, 2.5>, 0.8, <0, 1.5, 2.5>, 0 pigment { rgb <0.9, 0.8, 0.3> } }
