#version 3.7;
global_settings { assumed_gamma 1 }
#if (0) #debug "a" #elseif (0) #debug "b" #elseif (3) #debug "c\n" #else #debug "d" #end
#if (0) a b c ] } " unbalanced" ( ' #declare x 'y #else #debug "skipped fine\n" #end
#if (0) #if (1) #else #end #while (1) #end #for (I,0,1) #end #switch (1) #case (1) #end #macro X() #end #else #debug "nested skip\n" #end
#ifdef (X) #debug "X\n" #else #debug "no X\n" #end
