#version 3.7;
global_settings { assumed_gamma 1 }
#declare L = spline { linear_spline 0, <0,0,0> 1, <1,2,3> 3, <3,0,0> }
#declare Q = spline { quadratic_spline 0, <0,0,0> 1, <1,2,3> 3, <3,0,0> 4, 1 }
#declare C = spline { cubic_spline -1, 0 0, <0,0,0> 1, <1,2,3> 3, <3,0,0> 4, 1 }
#declare N = spline { natural_spline 0, <0,0,0,1> 1, <1,2,3,2> 3, <3,0,0,3> }
#for (I, -1, 5, 0.75)
  #debug concat(vstr(3, L(I), ",", 0, 6), " ", vstr(3, Q(I), ",", 0, 6), "\n")
  #debug concat(vstr(3, C(I), ",", 0, 6), " ", vstr(4, N(I), ",", 0, 6), "\n")
#end
