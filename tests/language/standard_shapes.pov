// shapes.inc, shapes2.inc and the boxes of their objects.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#include "shapes.inc" #include "shapes2.inc"
#macro Ends(O) ShowV(min_extent(O)) ShowV(max_extent(O)) #end #declare N = 0;
#declare A = object { Round_Box(<0, 0, 0>, <1, 2, 3>, 0.1, 0) } Ends(A) #declare B = object { Round_Cylinder(<0, 0, 0>, y, 0.5, 0.1, 0) } #declare C = object { Round_Cone(<0, 0, 0>, 1, y, 0.5, 0.1, 0) } #declare D = object { Wedge(30) } #declare E = object { Spheroid(<0, 0, 0>, <1, 2, 3>) } Ends(E) #declare F = object { Supertorus(1, 0.3, 1, 1, 0.1, 2) } #declare G = object { Wire_Box(<0, 0, 0>, <1, 1, 1>, 0.05, 0) } Ends(G) #declare H = object { Tetrahedron } Show(inside(H, 0)) #declare I = object { Octahedron } Show(inside(I, 0)) Show(inside(I, 2*x)) #declare J = object { Dodecahedron } Show(inside(J, 0)) Show(inside(J, <1.2, 0, 0>)) #declare K = object { Icosahedron } Show(inside(K, 0)) #declare L = object { Hexagon } Show(inside(L, 0)) #declare M = object { Rhomboid } Show(inside(M, 0)) #declare P = object { Pyramid2 } Show(inside(P, <0, 0.5, 0>)) Show(inside(Disk_Y, 0)) Show(inside(Cone_X, <0.5, 0, 0>)) Show(inside(Paraboloid_Y, <0, 1, 0>))

sphere { 0, 1 }
