// Elements that have no value.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare A = array[3]; Show(defined(A)) Show(defined(A[0])) #declare A[0] = 5; Show(defined(A[0])) Show(defined(A[1])) #undef A[0] Show(defined(A[0]))
#ifdef (A[2]) ShowS("set") #else ShowS("unset") #end #ifndef (A[2]) ShowS("unset") #end
#declare A[2] = 1; #ifdef (A[2]) ShowS("set") #end #undef A Show(defined(A)) #declare A = "now a string"; ShowS(A)

sphere { 0, 1 }
