#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = array[4]; #declare A[1] = 2;
#macro Dump(Arr)
  #debug "{"
  #for (I, 0, dimension_size(Arr,1)-1)
    #if (I) #debug "," #end
    #ifdef (Arr[I]) #debug str(Arr[I],0,2) #else #debug "-" #end
  #end
  #debug "}\n"
#end
Dump(A)
#declare B = A; Dump(B) #declare B[0] = 5; Dump(B) Dump(A)
#macro Grow(Arr, V) #local N = dimension_size(Arr,1); #local T = array[N+1]; #for (I,0,N-1) #ifdef (Arr[I]) #local T[I] = Arr[I]; #end #end #local T[N] = V; #declare Arr = T; #end
Grow(A, 7) Grow(A, 8) Dump(A)
