#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = array[2][2][2] { {{1,2},{3,4}}, {{5,6},{7,8}} }
#declare B = A;
#declare B[1][1][1] = 99;
#debug concat(str(A[1][1][1],0,0), " ", str(B[1][1][1],0,0), " ", str(dimension_size(A,3),0,0), "\n")
#declare M = array[2] { array[2] {1,2}, array[2] {3,4} }
#debug concat(str(M[1][0],0,0), "\n")
