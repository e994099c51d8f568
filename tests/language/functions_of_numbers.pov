// Functions of one number.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(abs(-3.5)) Show(ceil(1.2)) Show(ceil(-1.2)) Show(floor(1.8)) Show(floor(-1.2)) Show(int(2.9)) Show(int(-2.9))
Show(sqrt(2)) Show(exp(1)) Show(ln(10)) Show(log(1000)) Show(degrees(pi)) Show(radians(180)) Show(pow(2, 10)) Show(pow(2, -1)) Show(pow(-8, 3))
Show(sin(1)) Show(cos(1)) Show(tan(1)) Show(asin(0.5)) Show(acos(0.5)) Show(atan(2)) Show(atan2(1, -1)) Show(atan2(-1, -1)) Show(atan2(0, -1))
Show(sinh(1)) Show(cosh(1)) Show(tanh(1)) Show(asinh(1)) Show(acosh(2)) Show(atanh(0.5)) Show(pi)
Show(acos(1.5)) Show(asin(-7)) Show(sin(1e6)) Show(exp(-50))

sphere { 0, 1 }
