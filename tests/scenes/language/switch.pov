// #switch: cases, ranges, falling through, #else.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare I = 0;
#while (I < 6)
  #switch (I)
    #case (0) sphere { <-2 + 0.8*I, 0, 0>, 0.3 pigment { rgb <0.9, 0.3, 0.3> } } #break
    #case (1) sphere { <-2 + 0.8*I, -0.6, 0>, 0.2 pigment { rgb <0.9, 0.9, 0.3> } }
    #case (2) box { -0.25, 0.25 translate <-2 + 0.8*I, 0.2, 0> pigment { rgb <0.3, 0.9, 0.3> } } #break
    #range (3, 4) cylinder { <-2 + 0.8*I, -0.5, 0>, <-2 + 0.8*I, 0.4, 0>, 0.2 pigment { rgb <0.3, 0.5, 0.9> } } #break
    #else cone { <-2 + 0.8*I, -0.8, 0>, 0.35, <-2 + 0.8*I, 0.6, 0>, 0 pigment { rgb 0.9 } }
  #end
  #declare I = I + 1;
#end
