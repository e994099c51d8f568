// Arrays and elements passed to macros.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro Fill(List, Value) #local I = 0; #while (I < dimension_size(List, 1)) #declare List[I] = Value+I; #local I = I+1; #end #end
#macro Bump(Number) #declare Number = Number+1; #end
#declare A = array[3]; Fill(A, 10) Show(A[0]) Show(A[2]) Bump(A[1]) Bump(A[1]) Show(A[1])
#macro Total(List) #local Sum = 0; #local I = 0; #while (I < dimension_size(List, 1)) #local Sum = Sum+List[I]; #local I = I+1; #end Sum #end Show(Total(A))
#macro Swap(P, Q) #local T = P; #declare P = Q; #declare Q = T; #end Swap(A[0], A[2]) Show(A[0]) Show(A[2])
#declare M = array[2][2]{{1, 2}, {3, 4}} Bump(M[1][0]) Show(M[1][0])

sphere { 0, 1 }
