// One dimension.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = array[3]{10, 20, 30} Show(A[0]) Show(A[1]) Show(A[2]) Show(A[1.9999999999999]) Show(A[0.5+0.6])
#declare A[1] = 99; Show(A[1]) #declare B = A; #declare B[0] = 1; Show(A[0]) Show(B[0]) Show(A[A[0]/10])
Show(dimensions(A)) Show(dimension_size(A, 1)) Show(dimension_size(A, 2)) Show(dimension_size(A, 0))
#declare V = array[2]; #declare V[0] = x; #declare V[1] = <1, 2, 3>; ShowV(V[0]+V[1]) #declare V[0] = V[0]*5; ShowV(V[0])
#declare N = 4; #declare D = array[N*2]; Show(dimension_size(D, 1)) #declare I = 0; #while (I < 8) #declare D[I] = I*I; #declare I = I+1; #end Show(D[7]+D[3])
#local L = array[1]{5} #local L[0] = L[0]+1; Show(L[0])

sphere { 0, 1 }
