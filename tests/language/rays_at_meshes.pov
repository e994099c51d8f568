#version 3.7;
global_settings { assumed_gamma 1 }
#declare M = mesh { triangle { 0, x, y } triangle { 0, y, -x } inside_vector z }
#declare N = <0,0,0>;
#declare P = trace(M, <0.2,0.2,-5>, z, N);
#debug concat(vstr(3,P,",",0,5), " ", vstr(3,N,",",0,5), "\n")
#declare P = trace(M, <0.2,0.2,5>, -z, N);
#debug concat(vstr(3,P,",",0,5), " ", vstr(3,N,",",0,5), "\n")
#declare U = union { sphere { -2*x, 1 } box { <1,-1,-1>, <3,1,1> } rotate 90*y }
#for (I, -3, 3) #declare P = trace(U, <I*0.9,0,-9>, z, N); #debug concat(vstr(3,P,",",0,3), "|", vstr(3,N,",",0,3), "\n") #end
#debug concat(vstr(3,min_extent(U),",",0,3), vstr(3,max_extent(U),",",0,3), "\n")
