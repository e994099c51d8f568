// Directives between #switch and its first #case are carried out.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro M() ShowS("m") #end
#macro Quiet() #declare Called = 1; #end
#switch (1) #declare A = 5; #case (1) Show(A) #end
#switch (1) #if (1) ShowS("if") #end #case (1) ShowS("one") #end
#switch (1) #switch (2) #case (2) ShowS("inner") #end #case (1) ShowS("one") #end
#switch (1) #while (0) #end #case (1) ShowS("one") #end
#switch (2) #for (I, 1, 2) Show(I) #end #case (1) ShowS("one") #else ShowS("else") #end
#switch (1) M() Quiet() #range (0, 2) ShowS("one") Show(Called) #end
#switch (1) #macro N() ShowS("n") #end #case (1) N() #end
#local I = 0;
#while (I < 3)
  #switch (I)
    #if (I = 1) #declare Q = I; #else #declare Q = 7; #end
    #for (J, 0, 1) #declare Q = Q + 1; #end
    #case (1) ShowS("one") Show(Q) #break
    #else ShowS("else") Show(Q)
  #end
  #local I = I + 1;
#end
#if (0) #switch (1) #declare B = 3; #case (1) #end #end
#ifdef (B) ShowS("no") #end

sphere { 0, 1 }
