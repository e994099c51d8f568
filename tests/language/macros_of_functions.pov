#version 3.7;
global_settings { assumed_gamma 1 }
#declare F = function(x,y) { x + y }
#macro Ev(Fn, A, B) Fn(A, B) #end
#debug concat(str(Ev(F, 1, 2),0,0), "\n")
#declare S = spline { linear_spline 0, 0 1, 10 }
#macro Sp(Q, T) Q(T).x #end
#debug concat(str(Sp(S, 0.3),0,2), "\n")
#declare FA = array[2]; #declare FA[0] = function(x) { x*2 } #declare FA[1] = function(x) { x*3 }
#debug concat(str(FA[0](5),0,0), str(FA[1](5),0,0), "\n")
