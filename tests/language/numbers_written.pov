#version 3.7;
global_settings { assumed_gamma 1 }
#declare x1 = <1,2,3>.x+.5;
#debug concat(str(x1,0,2), str(1.e2,0,0), str(1e+2,0,0), "\n")
#declare Very_Long_Identifier_Name_That_Goes_On_And_On_For_Quite_A_While_Longer = 1;
#debug concat(str(Very_Long_Identifier_Name_That_Goes_On_And_On_For_Quite_A_While_Longer,0,0),"\n")
