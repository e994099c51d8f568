// What #break leaves.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#for (I, 1, 3) #for (J, 1, 3) #if (J = 2) #break #end Show(I*10+J) #end #end
#for (I, 1, 3) #switch (I) #case (2) #break #else Show(I) #end #end
#declare I = 0; #while (I < 10) #declare I = I+1; #switch (I) #case (3) Show(I) #break #case (4) #end #if (I > 4) #break #end #end Show(I)
#macro Find(V) #local I = 0; #while (I < 100) #if (I*I >= V) #break #end #local I = I+1; #end I #end Show(Find(50))

sphere { 0, 1 }
