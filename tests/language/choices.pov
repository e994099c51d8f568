#version 3.7;
global_settings { assumed_gamma 1 }
#debug vstr(3, (1 < 2 ? <1,2,3> : 5), ",", 0, 1) #debug "\n"
#debug vstr(3, (1 > 2 ? <1,2,3> : 5), ",", 0, 1) #debug "\n"
#declare I = 0;
#debug str((I = 0 ? 7 : 1/I), 0, 0) #debug "\n"
#debug str((0 ? 1 : 0 ? 2 : 3), 0, 0) #debug "\n"
#debug str((1 ? 0 ? 4 : 5 : 6), 0, 0) #debug "\n"
