// Several dimensions, and arrays within arrays.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = array[2][3]{{1, 2, 3}, {4, 5, 6}} Show(A[0][0]) Show(A[1][2]) Show(A[1][0]*A[0][2]) Show(dimensions(A)) Show(dimension_size(A, 1)) Show(dimension_size(A, 2))
#declare A[1][1] = 50; Show(A[1][1])
#declare C = array[2][2][2]{{{1, 2}, {3, 4}}, {{5, 6}, {7, 8}}} Show(C[1][0][1]) Show(C[0][1][1]) Show(dimensions(C))
#declare J = array[2]; #declare J[0] = array[1]{7} #declare J[1] = array[3]{8, 9, 10} Show(J[1][2]) Show(J[0][0]) Show(dimension_size(J[1], 1))
#declare J[1][0] = 80; Show(J[1][0])
#declare I = 0; #while (I < 2) #declare K = 0; #while (K < 3) Show(A[I][K]) #declare K = K+1; #end #declare I = I+1; #end

sphere { 0, 1 }
