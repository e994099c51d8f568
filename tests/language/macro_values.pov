// Macros in expressions.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro Square(N) N*N #end Show(Square(3)) Show(2*Square(3)) Show(Square(1+2)) Show(Square(2)+Square(3))
#macro Area(W, H) #local R = W*H; R #end #declare A = Area(3, 4); Show(A) #declare B = Area(2, 2)+1; Show(B)
#macro Up(V) #local P = V+y; P #end ShowV(Up(x)) ShowV(Up(Up(z)))
#macro Name(N) concat("name ", str(N, 0, 0)) #end ShowS(Name(5)) ShowS(concat(Name(1), Name(2)))
#macro Choose(N) #if (N > 2) 10 #else 20 #end #end Show((Choose(1))) Show((Choose(3))) #declare L = array[2]{(Choose(1)), (Choose(3))} Show(L[1])
#macro Sign(N) #switch (N) #range (-1e9, -1e-9) -1 #break #case (0) 0 #break #else 1 #end #end Show((Sign(-5))) Show((Sign(0))) Show((Sign(9)))
ShowV(<Square(2), Area(1, 2), 3>)

sphere { 0, 1 }
