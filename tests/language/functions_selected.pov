#version 3.7;
global_settings { assumed_gamma 1 }
#declare F = function(x) { select(x, -1, 0, 1) }
#declare G = function(x) { select(x, -1, 1) }
#debug concat(str(F(-2),0,0), str(F(0),0,0), str(F(3),0,0), str(G(0),0,0), str(G(-1),0,0), "\n")
#declare S = function(n) { sum(i, 1, n, i*i) }
#declare P = function(n) { prod(i, 1, n, i) }
#debug concat(str(S(4),0,0), " ", str(P(5),0,0), " ", str(S(0),0,0), " ", str(P(0),0,0), "\n")
#declare H = function(u,v) { min(u,v,3) + max(u,v) + mod(7,u) + floor(-0.5) + abs(-v) + int(2.7) + div(7,2) }
#debug concat(str(H(2,5),0,3), "\n")
#declare R = function { sqrt(x) + ln(y) + exp(z) + atan2(x,y) + radians(180) + degrees(pi) + sinh(x) + acosh(2) + atanh(0.5) + asinh(1) + cosh(0) + tanh(1) + log(100) }
#debug concat(str(R(1,1,1),0,8), "\n")
