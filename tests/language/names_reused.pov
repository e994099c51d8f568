#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = "x"; #declare A = 3; #declare A = <1,2>; #declare A = sphere { 0, 1 } #declare A = "back";
#debug concat(A, "\n")
#local B = 1; #declare B = 2; #debug concat(str(B,0,0), "\n")
#undef B #ifndef (B) #debug "no B\n" #end
#undef NeverThere
#ifdef (A) #ifdef (C) #debug "?" #else #debug "A only\n" #end #end
#if (defined(A) & !defined(C)) #debug "defined\n" #end
