// Which name is meant.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare G = 1; #macro A() #local G = 2; B() #end #macro B() Show(G) #declare G = 3; #end
A() Show(G) B() Show(G)
#macro C() #local H = 10; D() Show(H) #end #macro D() #local H = 20; Show(H) #end C() Show(defined(H))
#macro E() #declare New = 5; #local Hidden = 6; #end E() Show(New) Show(defined(Hidden))
#macro F(G) #declare G = G*10; Show(G) #end F(7) Show(G)
#macro Outer(P) Inner() #end #macro Inner() Show(P+1) #end Outer(41)
#for (I, 1, 2) #local InLoop = I; #end Show(InLoop) Show(I)

sphere { 0, 1 }
