// By value and by reference.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro Set(P) #declare P = 100; #end #macro SetLocal(P) #local P = 200; #end
#declare A = 1; Set(A) Show(A) #declare A = 1; SetLocal(A) Show(A) #declare A = 1; Set((A)) Show(A) #declare A = 1; Set(A*1) Show(A) #declare A = 1; Set(+A) Show(A)
#macro Two(P, Q) #declare P = P+Q; #end #declare A = 1; #declare B = 5; Two(A, B) Show(A) Two(A, A) Show(A) Two(B, 2*A) Show(B)
#macro Text(S) #declare S = concat(S, "!"); #end #declare T = "hey"; Text(T) Text(T) ShowS(T)
#macro Vec(V) #declare V = V*2; #end #declare W = <1, 2, 3>; Vec(W) ShowV(W)
#macro Type(P) #declare P = "changed"; #end #declare A = 3; Type(A) ShowS(A)
#macro None() 7 #end Show(None()) Show(None()*2+1)

sphere { 0, 1 }
