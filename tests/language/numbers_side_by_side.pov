// Before version 1.5 only parentheses join numbers.
#version 1.4;
#debug concat(vstr(3, <5 -1 -2>, ",", 0, 0), "\n")
#version 1.4;
#debug concat(vstr(3, <(3 -2) -1 0>, ",", 0, 0), "\n")
#version 1.4;
#debug concat(vstr(3, (2*<1 -2 3>), ",", 0, 0), "\n")
#version 1.4;
#debug concat(vstr(3, <abs(3 -5) -abs(2) -(1 -2)>, ",", 0, 0), "\n")
#declare N = 1;
#declare I = 0;
#while (I - 3 < 0)
  #declare I = (I + 1);
  #debug concat(vstr(3, <I -I -N>, ",", 0, 0), "\n")
#end
#version 1.5;
#debug concat(str(5 -2, 0, 0), "\n")
