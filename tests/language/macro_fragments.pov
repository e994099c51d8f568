// A macro may be any part of a statement.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro Center() 0, #end #macro Tail() 2 translate <1, 2, 3> } #end #macro Open(N) sphere { 0, N #end #macro Tex() pigment { rgb 1 } #end
#declare A = sphere { Center() 1 Tex() } ShowV(max_extent(A))
#declare B = sphere { 0, Tail() ShowV(max_extent(B))
#declare C = Open(3) } ShowV(min_extent(C))
#macro Three() 1, 2, 3 #end ShowV(<Three()>)
#declare D = union { #for (I, 0, 2) sphere { I*x, 0.5 } #end } ShowV(max_extent(D))
#macro Decl(V) #declare Made = V; #end Decl(4) Show(Made)

sphere { 0, 1 }
