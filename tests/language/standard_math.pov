// math.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#include "math.inc"
Show(even(4)) Show(odd(4)) Show(Interpolate(0.5, 0, 1, 10, 20, 1)) Show(Mean(array[4]{1, 2, 3, 4})) Show(Std_Dev(array[4]{1, 2, 3, 4}, 2.5)) ShowV(VMin(<1, 2, 3>)*x) Show(VMax(<1, 5, 3>)) Show(VAngleD(x, y)) Show(VDist(x, y)) ShowV(VPerp_To_Vector(y)) ShowV(VProject_Plane(<1, 2, 3>, y)) ShowV(VProject_Axis(<1, 2, 3>, x+y)) ShowV(VEq(x, x)*x)
Show(clip(5, 0, 3)) Show(clamp(5, 0, 3)) Show(adj_range(0.5, 10, 20)) Show(adj_range2(0.5, 0, 1, 5, 6)) Show(sind(30)) Show(cosd(60)) Show(tand(45)) Show(asind(0.5)) Show(acosd(0.5)) Show(atan2d(1, 1)) Show(max3(1, 5, 3)) Show(min3(4, 2, 3)) Show(f_sqr(5)) Show(sgn(-3)) ShowV(VSqr(<1, 2, 3>)) ShowV(VPow(<1, 2, 3>, 3)) Show(VRotation(x, y, z))

sphere { 0, 1 }
