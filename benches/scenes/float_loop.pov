// Ten million float operations: ten in each pass of a loop.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare I = 0;
#declare Sum = 0;
#declare Term = 1;
#while (I < 1000000)
  #declare Term = (Term*0.9 + I*1e-6)/(1 + 1e-7*I);
  #declare Sum = Sum + Term - 0.5;
  #declare I = I + 1;
#end
#debug concat("Sum ", str(Sum, 0, 6), "\n")
sphere { z*3, 1 }
