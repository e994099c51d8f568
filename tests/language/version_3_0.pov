#version 3.7;
global_settings { assumed_gamma 1 }
#version 3.0;
#declare F = 1 + <1,2,3>
#debug vstr(3,F,",",0,1)
#debug "\n"
#declare G = (3 = 3)
#debug str(G,0,0)
#debug "\n"
#declare H = (5 & 3)
#debug concat(str(H,0,0), str(!2,0,0), str((1 | 0),0,0), "\n")
#declare I = (5 > 3 & 0)
#debug concat(str(I,0,0), "\n")
