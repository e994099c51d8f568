#version 3.7;
global_settings { assumed_gamma 1 }
#macro Def() #macro Inner(X) #debug concat("inner ", str(X,0,0), "\n") #end #end
Def()
Inner(3)
#macro M(A) A #end
#debug concat(str(M(M(M(3)+1)*2),0,0), M(concat(" p", M("q"))), "\n")
#macro Fresh() #macro New(Y) concat("<", Y, ">") #end #end
Fresh()
#debug concat(New("2"), "\n")
#macro L() #local A = array[2] {1,2} #debug str(A[0],0,0) #local B = A; #local B[0] = 9; #debug str(A[0],0,0) #end
L() L() #debug "\n"
