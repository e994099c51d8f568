#version 3.7;
global_settings { assumed_gamma 1 }
#for (I, 0, 1, 0.1) #debug concat(str(I,0,1), " ") #end #debug "\n"
#for (I, 5, 1, -2) #debug concat(str(I,0,0), " ") #end #debug "\n"
#for (I, 1, 0) #debug "never" #end
#debug concat("after ", str(I,0,0), "\n")
#for (I, 0, 3) #declare I = I + 1; #debug concat(str(I,0,0), " ") #end #debug "\n"
#for (J, 0, 2) #for (K, 0, J) #if (K = 1) #break #end #debug concat(str(J,0,0), str(K,0,0), " ") #end #end #debug "\n"
#for (I, 0, 1, 1/3) #debug concat(str(I,0,4), " ") #end #debug "\n"
