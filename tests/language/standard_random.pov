// rand.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#include "rand.inc"
#declare R = seed(42); Show(SRand(R)) Show(RRand(5, 10, R)) Show(Rand_Bernoulli(0.5, R)) Show(Rand_Normal(0, 1, R)) Show(Rand_Gauss(0, 1, R)) Show(Rand_Exp(2, R)) ShowV(VRand(R)) ShowV(VRand_In_Sphere(R)) ShowV(VRand_On_Sphere(R)) ShowV(VRand_In_Box(0, <1, 2, 3>, R)) Show(Rand_Triangle(0, 1, 0.5, R))
#declare A = sphere { 0, 1 } ShowV(VRand_In_Obj(A, R)) Show(Rand_Poisson(3, R)) Show(Rand_Weibull(1, 2, R)) Show(Rand_Lognormal(0, 1, R))

sphere { 0, 1 }
