// #while and #for.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare I = 0; #while (I < 3) Show(I) #declare I = I+1; #end #while (0) Show(99) #end
#for (J, 1, 3) Show(J) #end Show(J) #for (J, 3, 1, -1) Show(J) #end Show(J) #for (J, 0, 0.3, 0.1) Show(J) #end Show(J)
#for (J, 5, 1) Show(99) #end Show(J) #for (J, 0, 10, 4) Show(J) #end #for (J, 1, 5) #declare J = J+1; Show(J) #end
#for (A, 0, 1) #for (B, 0, 1) Show(A*10+B) #end #end
#declare N = 3; #for (K, 1, N) #declare N = 1; Show(K) #end
#for (K, 1, 10) #if (K = 4) #break #end #end Show(K)
#declare I = 5; #while (I) #declare I = I-1; #if (I = 2) #break #end #end Show(I)

sphere { 0, 1 }
