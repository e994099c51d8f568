#version 3.7;
global_settings { assumed_gamma 1 }
#declare F = function { x < 2 & y > 1 | z = 3 }
#debug concat(str(F(1,2,0),0,0), str(F(3,2,0),0,0), str(F(3,0,3),0,0), "\n")
#declare F2 = function { (x >= 2) * 5 + (y != 1) * 7 }
#debug concat(str(F2(2,2,0),0,0), str(F2(3,1,1),0,0), "\n")
#declare K = 3;
#declare F3 = function { K*x }
#declare K = 4;
#debug concat(str(F3(2,0,0),0,0), "\n")
#declare V = <1,2,3>;
#declare Vx = V.x; #declare F4 = function { Vx*x + y }
#debug concat(str(F4(2,3,4),0,0), "\n")
#undef F
#declare F = function { -x*x - -y }
#debug concat(str(F(3,1,0),0,0), "\n")
#declare AA = array[2] {10, 20}
#declare A1 = AA[1]; #declare F5 = function { A1*x }
#debug concat(str(F5(3,0,0),0,0), "\n")
