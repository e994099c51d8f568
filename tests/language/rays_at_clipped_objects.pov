#version 3.7;
global_settings { assumed_gamma 1 }
#declare O = object { sphere { 0, 1 } clipped_by { plane { y, 0 } } translate y }
#declare N = <0,0,0>;
#debug concat(vstr(3,trace(O, <0,5,0>, -y, N),",",0,3), vstr(3,N,",",0,3), vstr(3,min_extent(O),",",0,3), vstr(3,max_extent(O),",",0,3), "\n")
#declare L = plane { y, 1 }
#debug concat(vstr(3,trace(L, <0,5,0>, -y, N),",",0,3), vstr(3,N,",",0,3), str(inside(L,0),0,0), str(inside(L,2*y),0,0), "\n")
