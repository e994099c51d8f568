#version 3.7;
global_settings { assumed_gamma 1 }
#debug/*c*/"a"//x
#debug "b\n"/* nested /* comment */ still */
# debug "spaced\n"
#
declare Sp = 3;
#debug concat(str(Sp,0,0),"\n")
#declare a_b1 = 1; #declare _x = 2; #declare A_b1 = 3;
#debug concat(str(a_b1,0,0),str(_x,0,0),str(A_b1,0,0),"\n")
