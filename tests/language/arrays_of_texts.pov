#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = array[3] { "a", "b" "c" }
#declare I = 0;
#while (I < dimension_size(A,1)) #debug A[I] #declare I = I + 1; #end
#debug "\n"
#declare B = array[2][3] { {1, 2, 3} {4 5 6} }
#debug concat(str(B[1][1],0,0), "\n")
#declare C = array[4];
#declare C[2] = sphere { 0, 2 }
#ifdef (C[2]) #debug "2 set\n" #end
#ifndef (C[1]) #debug "1 unset\n" #end
#debug vstr(3, max_extent(C[2]), ",", 0, 1) #debug "\n"
#declare C[2.9] = sphere { 0, 3 }
#debug vstr(3, max_extent(C[2]), ",", 0, 1) #debug "\n"
