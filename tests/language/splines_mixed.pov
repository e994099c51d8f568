#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = spline { 0, 5 2, 7 1, 6 }
#debug concat(str(S(0.5).x,0,4), " ", vstr(3, S(1.5), ",", 0, 4), "\n")
#declare T = spline { cubic_spline 0, 3 1, 100 3, 1 }
#debug vstr(3, T(0.5), ",", 0, 4) #debug "\n"
#debug vstr(3, S(0.5, cubic_spline), ",", 0, 4) #debug "\n"
#debug vstr(3, S(0.5, natural_spline), ",", 0, 4) #debug "\n"
#debug vstr(3, S(0.5, linear_spline), ",", 0, 4) #debug "\n"
#debug vstr(3, S(0.5, quadratic_spline), ",", 0, 4) #debug "\n"
#debug vstr(3, S(0.5), ",", 0, 4) #debug "\n"
#declare U = spline { linear_spline 0, <1,2> 1, <3,4> }
#debug vstr(2, U(0.25), ",", 0, 4) #debug "\n"
#debug vstr(5, U(0.25), ",", 0, 4) #debug "\n"
