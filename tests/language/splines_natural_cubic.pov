// Natural and Catmull-Rom splines.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare N = spline { natural_spline 0, <0, 0, 0> 1, <1, 2, 3> 3, <2, 2, 2> 4, <0, 1, 5> } #declare C = spline { cubic_spline 0, <0, 0, 0> 1, <1, 2, 3> 3, <2, 2, 2> 4, <0, 1, 5> 5, <1, 1, 1> }
#for (T, -0.5, 4.5, 0.5) ShowV(N(T)) #end #for (T, -0.5, 5.5, 0.5) ShowV(C(T)) #end

sphere { 0, 1 }
