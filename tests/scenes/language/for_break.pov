// #for with a step, #break out of the inner loop.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#for (I, -1.8, 1.8, 0.6)
  #for (J, -0.8, 1, 0.45)
    #if (I*I + J*J > 2.2) #break #end
    box { <-0.2, -0.15, -0.2>, <0.2, 0.15, 0.2> translate <I, J, 0> pigment { rgb <0.5 + I/4, 0.5, 0.5 - J/4> } }
  #end
#end
