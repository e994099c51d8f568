#version 3.7;
global_settings { assumed_gamma 1 }
#macro Fill(Arr, N) #for (I, 0, N-1) #declare Arr[I] = I*I; #end #end
#declare B = array[4];
Fill(B, 4)
#debug concat(str(B[0],0,0), str(B[1],0,0), str(B[2],0,0), str(B[3],0,0), "\n")
#macro Row(Arr, I, J) Arr[I][J] #end
#declare M = array[2][3] { {1,2,3}, {4,5,6} }
#debug concat(str(Row(M,1,2),0,0), "\n")
#macro Pass(Arr) Fill(Arr, 2) #declare Arr[3] = -1; #end
Pass(B)
#debug concat(str(B[1],0,0), str(B[3],0,0), "\n")
#macro MakeArr() array[2] {7, 8} #end
#declare C = MakeArr()
#debug concat(str(C[1],0,0), "\n")
