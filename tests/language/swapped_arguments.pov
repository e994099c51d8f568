#version 3.7;
global_settings { assumed_gamma 1 }
#macro Inc(X) #declare X = X + 1; #end
#declare N = 1;
Inc(N) Inc(N)
#debug concat(str(N,0,0),"\n")
#declare A = array[3] {1,2,3}
Inc(A[1]) Inc(A[1])
#debug concat(str(A[1],0,0),"\n")
#macro Swap(A_,B_) #local T = A_; #declare A_ = B_; #declare B_ = T; #end
#declare P = <1,2,3>; #declare Q = 5;
Swap(P, Q)
#debug concat(str(P,0,0), " ", vstr(3,Q,",",0,0), "\n")
Swap(A[0], A[2])
#debug concat(str(A[0],0,0), str(A[2],0,0), "\n")
#declare S = "text";
Swap(S, P)
#debug concat(P, " ", str(S,0,0), "\n")
Swap(A[0], S)
#debug concat(str(A[0],0,0), str(S,0,0), "\n")
