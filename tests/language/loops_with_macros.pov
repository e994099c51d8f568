#version 3.7;
global_settings { assumed_gamma 1 }
#declare I = 3;
#macro Cond() (I > 0) #end
#while (Cond()) #debug str(I,0,0) #declare I = I - 1; #end #debug "\n"
#macro Early(N) #for (I, 0, 9) #if (I = N) #break #end #debug str(I,0,0) #end #debug "\n" #end
Early(3) Early(0)
#local L = 1;
#while (L < 100) #local L = L * 3; #end
#debug concat(str(L,0,0), "\n")
