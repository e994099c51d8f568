// Functions that call themselves: the reference warns, and computes.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare Factorial = function(x) { select(x - 1, 1, 1, x*Factorial(x - 1)) } Show(Factorial(5)) Show(Factorial(0)) Show(Factorial(20))
#declare Count = function(x) { select(x, 0, 0, 1 + Count(x - 1)) } Show(Count(1000)) Show(Count(2.5))
#declare Gcd = function(x, y) { select(y, x, x, Gcd(y, x - y*floor(x/y))) } Show(Gcd(48, 18)) Show(Gcd(17, 5))
#declare Fib = function(n) { select(n - 2, n, n, Fib(n - 1) + Fib(n - 2)) } Show(Fib(20))

sphere { 0, 1 }
