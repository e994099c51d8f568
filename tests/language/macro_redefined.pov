// The last definition counts; #break leaves a macro.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro M() 1 #end Show(M()) #macro M() 2 #end Show(M()) #macro M(A) A #end Show(M(5))
#macro Early(N) Show(N) #if (N > 1) #break #end Show(-N) #end Early(1) Early(2) Show(0)
#macro Loop() #local I = 0; #while (1) #local I = I+1; #if (I = 4) #break #end #end Show(I) #end Loop()
#undef M Show(defined(M)) #macro N() #end Show(defined(N)) N()

sphere { 0, 1 }
