#version 3.7;
global_settings { assumed_gamma 1 }
#declare C = color red 1 green 0.5; #declare D = rgb 0.3; #declare E = srgb <0.5,0.5,0.5>; #declare F = C*0.5 + D;
#debug concat(vstr(5,C,",",0,4), " ", vstr(5,D,",",0,4), "\n", vstr(5,E,",",0,5), " ", vstr(5,F,",",0,4), "\n")
#declare H = rgbt <C.red, 0, 1, 0.5>; #declare I = color rgb x + y*2;
#debug concat(vstr(5,H,",",0,4), " ", vstr(5,I,",",0,4), "\n")
#declare J = color C transmit 0.25 blue 2;
#debug concat(vstr(5,J,",",0,4), "\n")
