#version 3.7;
global_settings { assumed_gamma 1 }
#declare F = function { x*y + z }
#declare G = function(a, b) { pow(F(a, b, 1), 2) }
#declare P = function { pigment { gradient x color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.25>] } } }
#declare Q = function { pattern { checker } }
#debug concat(str(F(2,3,4),0,3), " ", str(G(2,3),0,3), " ", vstr(5,P(0.5,0,0),",",0,4), " ", str(P(0.5,0,0).gray,0,4), "\n")
#debug concat(str(Q(0.5,0.5,0.5),0,1), str(Q(1.5,0.5,0.5),0,1), str(P(0.25,0,0).green,0,4), "\n")
#declare T = function { transform { rotate 90*z translate x scale 2 } }
#debug concat(vstr(3,T(1,0,0),",",0,4), "\n")
#declare I = function { transform { rotate 90*z translate x scale 2 inverse } }
#debug concat(str(I(1,0,0).y,0,4), "\n")
