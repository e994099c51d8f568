#version 3.7;
global_settings { assumed_gamma 1 }
#macro F1(N) #if (N<2) #local R=N; #else #local R=5; #end R #end
#local Q = F1(3) + F1(1);
#debug concat(str(Q,0,0), "\n")
#macro F2(N) #if (N<2) #local R=N; #else #local R=2*F2(N-1)+F2(N-1); #end R #end
#local Q = F2(5);
#debug concat(str(Q,0,0), "\n")
#macro F3(N) #local R = N; R #end
#macro G3(N) 4 #end
#local Q = G3(2) + F3(1);
#debug concat(str(Q,0,0), "\n")
#local Q = F3(2) + F3(1) - F3(7) + 2*F3(4);
#debug concat(str(Q,0,0), "\n")
#macro Fib(N) #if (N<2) #local R=N; #else #local R=Fib(N-1)+Fib(N-2); #end (R) #end
#debug concat(str(Fib(12),0,0), "\n")
#macro Rib(N) #if (N<2) #local R=N; #else #local R=Rib(N-1)+Rib(N-2); #end R #end
#declare F = Rib(9);
#declare V = <Rib(3), Fib(4) + 1, F>;
#debug concat(str(F,0,0), " ", vstr(3, V, ",", 0, 0), "\n")
