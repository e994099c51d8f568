#version 3.7;
global_settings { assumed_gamma 1 }
#declare F = function { pigment { bozo color_map { [0 rgb <1,0,0>] [1 rgb <0,1,1>] } scale 0.3 } }
#declare G = function(x,y) { F(x,y,0).red + F(x,y,1).blue }
#debug concat(str(G(0.3,0.4),0,6), " ", vstr(3, F(0.3,0.4,0), ",", 0, 6), "\n")
#declare H = function { pattern { function { sin(x)*0.5+0.5 } scale 2 } }
#debug concat(str(H(1,0,0),0,6), "\n")
#declare W = function { pattern { wood turbulence 0.2 rotate 30*x } }
#debug concat(str(W(0.3,0.1,0.2),0,6), "\n")
