#version 3.7;
global_settings { assumed_gamma 1 }
#fopen F "target/t1.txt" write
#write (F, 1, ",", <1,2,3>, ",", "str with, comma", ",\n", -1e-20, ",", 1e20, ",", 0.1, ",\"x\",", <1,2,3,4,5>)
#fclose F
#fopen F "target/t1.txt" read
#declare N = 0;
#read (F, A, V)
#debug concat(str(A,0,5), " ", vstr(3,V,",",0,3), "\n")
#fclose F
#fopen F "target/t1b.txt" write
#write (F, 1, ",", <1,2,3>, ",", "\"str with, comma\"", ",\n", -1e-20, ",", 1e20, ",", 0.1, ",\"x\",", <1,2,3,4,5>, ",", <1,2>)
#fclose F
#fopen F "target/t1b.txt" read
#read (F, A, V, S, B, C, D, X, W, Z)
#debug concat(str(A,0,5), " ", vstr(3,V,",",0,3), " ", S, "\n")
#debug concat(str(B,0,25), " ", str(C,0,3), " ", str(D,0,15), " ", X, "\n", vstr(5,W,",",0,2), vstr(2,Z,",",0,2), "\n")
#ifdef (F) #debug "open\n" #else #debug "closed\n" #end
