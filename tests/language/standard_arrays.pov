// arrays.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#include "arrays.inc"
#declare A = array[5]{5, 3, 9, 1, 7} Sort_Array(A) #for (I, 0, 4) Show(A[I]) #end Reverse_Array(A) Show(A[0]) Show(A[4]) #declare R = seed(3); Show((Rand_Array_Item(A, R))) Resize_Array(A, 7) Show(dimension_size(A, 1)) #declare B = array[2][3]{{1, 2, 3}, {4, 5, 6}}
#declare C = array[6]{4, 2, 6, 1, 3, 5} Sort_Partial_Array(C, 0, 3) #for (I, 0, 5) Show(C[I]) #end

sphere { 0, 1 }
