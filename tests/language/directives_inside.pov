// Directives within expressions and blocks.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare Q = 1; ShowV(<1, #if (Q) 2 #else 3 #end, 3>) Show((1+#if (0) 5 #else 7 #end)*2)

#declare V = <#declare W = 5; W, W+1, W+2>; ShowV(V) #declare B = (#local T = 3; T*T); Show(B)
#declare S = sphere { 0, #ifdef (Q) 2 #else 1 #end #if (Q) translate x #end } ShowV(max_extent(S))
Show(max(1, #if (Q) 4, #end 3)) ShowS(concat("a", #if (1) "b", #end "c")) # declare Spaced = 4; Show(Spaced) #
declare Wrapped = 6; Show(Wrapped)

sphere { 0, 1 }
