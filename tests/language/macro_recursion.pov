// Macros that call themselves.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro Fact(N) #if (N <= 1) 1 #else (N*Fact(N-1)) #end #end Show((Fact(5))) Show((Fact(10)))
#macro Fib(N) #if (N < 2) N #else (Fib(N-1)+Fib(N-2)) #end #end Show((Fib(12)))
#macro Gcd(A, B) #if (B = 0) A #else Gcd(B, mod(A, B)) #end #end Show((Gcd(48, 18)))
#macro Count(N) #if (N > 0) Count(N-1) Show(N) #end #end Count(3)
#macro Even(N) #if (N = 0) 1 #else Odd(N-1) #end #end #macro Odd(N) #if (N = 0) 0 #else Even(N-1) #end #end Show((Even(10))) Show((Even(7)))
#macro Deep(N) #if (N = 0) 0 #else 1+Deep(N-1) #end #end Show((Deep(80)))

sphere { 0, 1 }
