// Writing and reading.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#fopen F "target/written.txt" write #write (F, 1, ", ", 1/3, ",", -2.5e10, ",\n") #write (F, <1, 2, 3>, ",", "\"text\"", ", ", <4.5, 5, 6>, "\n") #fclose F Show(defined(F))
#fopen F "target/written.txt" read #read (F, A, B, C) Show(A) Show(B) Show(C) #read (F, V, S) ShowV(V) ShowS(S) Show(defined(F)) #read (F, W) Show(W.x) Show(W.z) Show(defined(F))
#fopen F "target/written.txt" append #write (F, ", 77") #fclose F #fopen G "target/written.txt" read #declare N = 0; #while (defined(G)) #read (G, Item) #declare N = N+1; #end Show(N) Show(Item)
#fopen H "target/written.txt" write #write (H, "1, 2\n3 4 5") #fclose H #fopen H "target/written.txt" read #declare Sum = 0; #while (defined(H)) #read (H, Q) Show(Q) #end

sphere { 0, 1 }
