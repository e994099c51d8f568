#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat(vstr(3, -<1,2,3>, ",", 0, 0), " ", vstr(3, !<1,0,3>, ",", 0, 0), "\n")
#declare V = (<1,2,3> = <1,2,4>);
#debug vstr(3, V, ",", 0, 0) #debug "\n"
#declare V = (<1,2,3> < 2);
#debug vstr(3, V, ",", 0, 0) #debug "\n"
#declare V = (<1,0,3> & <1,1,0>) + (x | y);
#debug vstr(3, V, ",", 0, 0) #debug "\n"
