// Truncation goes through 32 bits.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(int(1e9)) Show(int(-1e9)) Show(int(3e9)) Show(int(-3e9)) Show(int(0.999999999999))
Show(div(7, 2)) Show(div(-7, 2)) Show(div(7, -2)) Show(div(1e12, 7)) Show(mod(5, 3)) Show(mod(-5, 3)) Show(mod(5, -3)) Show(mod(5.5, 2)) Show(mod(-0.5, 1))
Show(bitwise_and(12, 10)) Show(bitwise_or(12, 10)) Show(bitwise_xor(12, 10)) Show(bitwise_and(255, 15, 6)) Show(bitwise_or(1, 2, 4, 8)) Show(bitwise_xor(-1, 1)) Show(bitwise_and(7.9, 3.9))

sphere { 0, 1 }
