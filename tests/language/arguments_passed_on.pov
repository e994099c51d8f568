#version 3.7;
global_settings { assumed_gamma 1 }
#declare V = <1,2,3>;
#macro Set(C, X) #declare C = X; #end
#macro Outer(M) #local L = M; Set(L, 9) #debug concat(str(L,0,0), " ", str(M,0,0), "\n") Set(M, 4) #end
#declare G = 1;
Outer(G)
#debug concat(str(G,0,0), "\n")
#macro Def(I) #ifdef (I) #debug "d\n" #else #debug "u\n" #end #end
Def(G) Def(V)
#macro Undo(I) #undef I #ifdef (I) #debug "still\n" #else #debug "gone\n" #end #end
Undo(G)
#ifdef (G) #debug "outside still\n" #else #debug "outside gone\n" #end
