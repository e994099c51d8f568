#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat("tab\tq\"b\\s\a'\'u\u0041\n")
#declare S = "multi
line";
#debug concat(S, str(strlen(S),0,0), "\n")
#debug concat(concat("a"), concat("b","c",concat("d")), "\n")
#debug concat(str(12,5,0), "|", str(12,-5,0), "|", str(-12,-5,0), "|", str(12.345,8,1), "|", str(12.345,-8,1), "\n")
