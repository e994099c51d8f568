#version 3.7;
global_settings { assumed_gamma 1 }
#macro P(T) pigment { rgb T } #end
#macro Obj(A, B) object { A P(B) } #end
#declare O = Obj(sphere { 0, 1 }, <1,0,0>)
#debug vstr(3, max_extent(O), ",", 0, 2) #debug "\n"
#declare T = transform { rotate 90*z translate x }
#macro Obj3(A, B, C) object { A P(B) transform { C } } #end
#declare O2 = Obj3(box { 0, <1,2,3> }, 1, T)
#debug vstr(3, max_extent(O2), ",", 0, 2) #debug "\n"
#declare O3 = Obj3(box { 0, <1,2,3> }, 1, transform { T inverse })
#debug str(min_extent(O3).y, 0, 2) #debug "\n"
#declare O4 = object { O3 scale 2 }
#debug str(max_extent(O4).z, 0, 2) #debug "\n"
