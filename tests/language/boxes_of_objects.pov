#version 3.7;
global_settings { assumed_gamma 1 }
#declare D = torus { 2, 0.5 rotate 30*x }
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = cone { -y, 2, y, 1 rotate 40*z }
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = julia_fractal { <-0.1,0.2,0,0> }
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = quadric { <1,2,3>,0,0,-1 }
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = plane { y, 0 }
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = parametric { function{u},function{v},function{u*v} <0,0>,<1,1> }
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = prism { conic_sweep linear_spline 0.5, 1, 5, <1,1>,<-1,1>,<-1,-1>,<1,-1>,<1,1> }
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = mesh { triangle { 0, x, y } triangle { 0,y,z } rotate 45*y }
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = union { sphere { 0,1 } plane { y, 0 } } 
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = intersection { sphere { 0,1 } plane { y, 0 } plane { x, 0.5 } } 
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = isosurface { function { x } contained_by { box { -1, <1,2,3> } } } 
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = sphere { 0,1 bounded_by { box { -3, 2 } } } 
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
#declare D = cubic { <1,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,-1> }
#debug concat(vstr(3,min_extent(D),",",0,5), "\n", vstr(3,max_extent(D),",",0,5), "\n")
