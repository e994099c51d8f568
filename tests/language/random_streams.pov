#version 3.7;
global_settings { assumed_gamma 1 }
#declare R = array[2];
#declare R[0] = seed(1); #declare R[1] = seed(2);
#debug concat(str(rand(R[0]),0,10), " ", str(rand(R[1]),0,10), " ", str(rand(R[0]),0,10), "\n")
#macro Next(S) rand(S) #end
#debug concat(str(Next(R[0]),0,10), " ", str(Next(R[0]),0,10), "\n")
