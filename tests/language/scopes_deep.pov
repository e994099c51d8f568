#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = 1;
#macro M() #local A = 2; #debug str(A,0,0) #declare A = 3; #debug str(A,0,0) N() #debug str(A,0,0) #end
#macro N() #debug str(A,0,0) #declare A = 5; #end
M() #debug concat(str(A,0,0), "\n")
#macro K(A) #debug str(A,0,0) #local A = 9; #debug str(A,0,0) #end
#declare B = 4;
K(B) #debug concat(str(B,0,0), str(A,0,0), "\n")
#macro R(N_) #local L = N_; #if (N_ > 0) R(N_-1) #end #debug str(L,0,0) #end
R(4) #debug "\n"
