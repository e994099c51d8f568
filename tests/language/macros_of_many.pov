#version 3.7;
global_settings { assumed_gamma 1 }
#macro Ret(A) #local R = A * 2; R #end
#debug concat(str(Ret(4),0,0), "\n")
#declare Q = Ret(5);
#debug concat(str(Q,0,0), "\n")
#macro Lots(A,B,C,D,E,F,G,H,I,J) A+B+C+D+E+F+G+H+I+J #end
#debug concat(str(Lots(1,2,3,4,5,6,7,8,9,10)*2,0,0), "\n")
