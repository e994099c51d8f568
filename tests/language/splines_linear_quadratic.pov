// Splines of straight lines and of parabolas.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare L = spline { linear_spline 0, <0, 0, 0> 1, <1, 2, 3> 3, <2, 2, 2> 4, <0, 1, 5> }
#for (T, -0.5, 4.5, 0.5) ShowV(L(T)) #end #for (T, -0.5, 4.5, 0.5) ShowV(L(T, quadratic_spline)) #end

sphere { 0, 1 }
