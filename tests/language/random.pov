// Streams of random numbers.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare R = seed(0); Show(rand(R)) Show(rand(R)) Show(rand(R))
#declare S = seed(1); Show(rand(S)) Show(rand(S))
#declare T = seed(1.9); Show(rand(T)) #declare N = seed(-5); Show(rand(N)) #declare B = seed(12345); Show(rand(B))
#declare Q = R; Show(rand(Q)) Show(rand(R)) Show(rand(Q))
#declare R = seed(0); Show(rand(R)+rand(R)*10) Show(rand(seed(7)))
#macro Draw(Stream) rand(Stream) #end Show(Draw(S)) Show(Draw(S)) Show(rand(S))
#declare I = 0; #declare Sum = 0; #while (I < 1000) #declare Sum = Sum + rand(B); #declare I = I+1; #end Show(Sum)

sphere { 0, 1 }
