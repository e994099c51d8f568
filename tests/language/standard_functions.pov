// functions.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#include "functions.inc"
Show(f_sphere(1, 2, 3, 1)) Show(f_torus(1, 2, 3, 2, 0.5)) Show(f_noise3d(0.1, 0.2, 0.3)) Show(f_r(1, 2, 3)) Show(f_th(1, 2, 3)) Show(f_ph(1, 2, 3)) Show(f_snoise3d(0.1, 0.2, 0.3)) Show(f_sine_wave(0.3, 2, 3)) Show(f_scallop_wave(0.3, 2, 3)) Show(f_agate(0.1, 0.2, 0.3)) Show(f_bozo(0.1, 0.2, 0.3)) Show(f_dents(0.1, 0.2, 0.3)) Show(f_marble(0.1, 0.2, 0.3)) Show(f_granite(0.1, 0.2, 0.3)) Show(f_wood(0.1, 0.2, 0.3)) Show(f_superellipsoid(0.1, 0.2, 0.3, 0.5, 0.5)) Show(f_rounded_box(1, 2, 3, 0.1, 1, 1, 1)) Show(f_heart(0.1, 0.2, 0.3, 1)) Show(f_helix1(1, 2, 3, 2, 1, 0.3, 1, 1, 1, 0)) Show(f_ridge(0.1, 0.2, 0.3, 2, 3, 0.5, 0.5, 0.4, 0)) Show(f_crackle(0.1, 0.2, 0.3)) Show(f_leopard(1, 2, 3)) Show(f_onion(1, 2, 3)) Show(f_radial(1, 2, 3)) Show(f_ripples(1, 2, 3)) Show(f_waves(1, 2, 3)) Show(f_wrinkles(1, 2, 3)) Show(f_spotted(1, 2, 3)) Show(f_cylindrical(0.1, 0.2, 0.3)) Show(f_spherical(0.1, 0.2, 0.3)) Show(f_boxed(0.1, 0.2, 0.3)) Show(f_planar(0.1, 0.2, 0.3)) Show(f_bumps(0.1, 0.2, 0.3))

sphere { 0, 1 }
