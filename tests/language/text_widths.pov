#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat(str(3,2,0.6), "|", str(3,1.7,1.9), "\n")
#debug concat(substr("hello",1,5), "|", substr("hello",5,1), "\n")
#debug concat(datetime(0), "|", datetime(-219145), "|", datetime(2921939), "\n")
#debug concat(str(val(" 12 "),0,0), str(val("3abc"),0,0), str(val(".5"),0,1), str(val("-"),0,0), "\n")
