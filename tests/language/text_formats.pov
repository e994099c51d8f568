#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat(str(1/3,10,4), "|", str(-1/3,-10,4), "|", str(1e15,0,-1), "|", str(pi,0,-3), "|", str(2.5,0,0), str(3.5,0,0), "\n")
#debug concat(str(-0.0001,0,2), "|", str(-0,0,0), "|", str(0*-1,0,1), "|", str(1e-7,0,8), "|", str(123456789.123456789,0,9), "\n")
#debug concat(vstr(5,<1,2,3,4,5>,"<>",6,1), "|", vstr(2,<1,2,3>,", ",0,2), "|", vstr(3,7,"-",0,0), "\n")
#debug concat(substr("abcdef",2,3), strupr("aBc9\u00e4"), strlwr("ABC"), chr(65), str(asc("a"),0,0), "\n")
#debug concat(str(strlen(""),0,0), str(strlen("a\nb\\"),0,0), str(strcmp("a","b"),0,0), str(strcmp("b","a"),0,0), str(strcmp("a","a"),0,0), str(strcmp("ab","a"),0,0), "\n")
#debug concat(str(val("12.5"),0,2), " ", str(val("-1e3"),0,0), " ", str(val("0.5e-1"),0,3), "\n")
