#version 3.7;
global_settings { assumed_gamma 1 }
#include "functions.inc"
#declare F = function { f_noise3d(x,y,z) + f_ridged_mf(x,y,z,0.1,3,5,0.6,0.6,1) }
#debug concat(str(F(0.1,0.2,0.3),0,8), " ", str(f_sphere(1,2,3,1),0,8), " ", str(f_noise_generator(0.1,0.2,0.3,1),0,8), "\n")
#declare A = function { f_r(x,y,z) + f_th(x,y,z) + f_ph(x,y,z) }
#debug concat(str(A(1,2,3),0,8), "\n")
