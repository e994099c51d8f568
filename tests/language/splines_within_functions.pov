#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = spline { cubic_spline 0, x 0, y 1, z 1, 2*x }
#debug vstr(3, S(0), ",", 0, 4) #debug "\n"
#debug vstr(3, S(0.5), ",", 0, 4) #debug "\n"
#debug vstr(3, S(1), ",", 0, 4) #debug "\n"
#declare F = function { spline { linear_spline 0, <1,2,3> 1, <4,5,6> } }
#debug vstr(3, F(0.5), ",", 0, 4) #debug "\n"
#declare G = function(a) { F(a).y * 2 }
#debug str(G(0.5), 0, 4) #debug "\n"
