#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat(vstr(3,vturbulence(2,0.5,6,<0.1,0.2,0.3>),",",0,8), "\n")
#debug concat(vstr(3,vturbulence(3,0.4,3,x),",",0,8), "\n")
