#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = <1,2>; #declare B = <1,2,3,4>; #declare C = 5;
#debug vstr(5, A + B, ",", 0, 1) #debug "\n"
#debug vstr(5, C * B, ",", 0, 1) #debug "\n"
#debug vstr(5, A * 2 + C, ",", 0, 1) #debug "\n"
#declare R = rgb A;
#debug vstr(5, R, ",", 0, 1) #debug "\n"
#declare R = rgbf <1,2,3> + <0,0,0,7>;
#debug vstr(5, R, ",", 0, 1) #debug "\n"
#debug concat(str(A.x,0,0), str(A.y,0,0), str(vlength(<3,4>),0,2), "\n")
#debug concat(vstr(3, vcross(x, <0,1>), ",", 0, 1), " ", str(vdot(2, <1,2,3>),0,1), "\n")
#debug concat(vstr(3, vnormalize(<1,1>), ",", 0, 5), " ", vstr(3, vrotate(x, 90), ",", 0, 3), " ", vstr(3, vaxis_rotate(x, z, 45), ",", 0, 5), "\n")
