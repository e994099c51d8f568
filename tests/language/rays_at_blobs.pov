#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = sphere { 0, 1 inverse }
#debug concat(str(inside(S, 0),0,0), str(inside(S, 2),0,0), "\n")
#declare H = height_field { function 4, 4 { x } }
#debug concat(vstr(3,trace(H, <0.5,5,0.5>, -y),",",0,3), "\n")
#declare B = blob { threshold 0.5 sphere { 0, 1, 1 } cylinder { 0, 2*x, 0.5, 1 } }
#declare N = <0,0,0>;
#debug concat(vstr(3,trace(B, <0,5,0>, -y, N),",",0,4), str(N.y,0,4), str(inside(B,x),0,0), "\n")
#declare I = isosurface { function { x*x+y*y+z*z-1 } contained_by { sphere { 0, 2 } } max_gradient 5 accuracy 0.0001 }
#debug concat(vstr(3,trace(I, <0,0,-5>, z, N),",",0,3), vstr(3,N,",",0,3), "\n")
