#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = array[3] {1,2,3}
#undef A[1]
#ifdef (A[1]) #debug "yes\n" #else #debug "no\n" #end
