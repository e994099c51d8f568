#version 3.7;
global_settings { assumed_gamma 1 }
#declare V = <1,2,3,4,5>;
#debug concat(str(V.red,0,0), str(V.filter,0,0), str(V.transmit,0,0), str(V.t,0,0), str(V.u,0,0), str(V.v,0,0), str(V.gray,0,4), "\n")
#debug concat(str((x+2*y).y,0,0), str(vrotate(x,90*z).y,0,2), "\n")
#debug concat(vstr(3, x/2, ",", 0, 2), vstr(3, <1,2,3>/<2,4,6>, ",", 0, 2), vstr(3, 6/<1,2,3>, ",", 0, 2), "\n")
#declare V = V / 2 - 1;
#debug vstr(5, V, ",", 0, 2) #debug "\n"
