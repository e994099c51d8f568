// #local in a macro hides the outer name; #declare reaches it.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Size = 0.7;
#macro Small() #local Size = 0.3; sphere { <-1.3, 0, 0>, Size pigment { rgb <0.9, 0.3, 0.3> } } #end
#macro Change() #declare Size = 0.5; #end
Small()
sphere { 0, Size pigment { rgb <0.3, 0.9, 0.3> } }
Change()
sphere { <1.3, 0, 0>, Size pigment { rgb <0.3, 0.3, 0.9> } }
