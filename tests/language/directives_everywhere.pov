#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = concat("a", #if (1) "b" #else "c" #end);
#debug concat(S, "\n")
#declare V = < #if (1) 1, #end 2, 3>;
#debug concat(vstr(3, V, ",", 0, 0), "\n")
sphere { #local R = 2; <0,0,0>, R #if (R > 1) scale 2 #end pigment { #ifdef (Q) rgb Q #else rgb 1 #end } }
#declare O = union { #for (I, 0, 2) sphere { I*x, 0.5 } #end }
#debug concat(vstr(3, max_extent(O), ",", 0, 1), "\n")
#if (1) sphere { 0, 1 #else box { 0, 1 #end pigment { rgb 1 } }
#declare I = 0;
#while (I < 3) #declare I = I + 1; #if (I = 2) #debug "two" #end #debug str(I,0,0) #end
#while (I > 0) #debug str(I,0,0) #declare I = I - 1; #switch (I) #case (1) #debug "!" #break #end #end
#ifdef (A) #debug "x" #elseif (1) #debug "y" #end
#ifndef (A) #debug "n" #else #debug "d" #end
#declare A = array[2];
#ifdef (A[0]) #debug "n\n" #else #debug "d\n" #end
#declare N = 010; #debug concat(str(N,0,0), str(1e400,0,0), "\n")
#declare S = "a"; #if (S = "a") #debug "eq" #end #if (S != "b") #debug "ne" #end
#if ((S = "a")) #debug "eq" #end #debug str(strcmp(S,"b"),0,0)
#debug concat("a" , "b" "c", "d\n")
