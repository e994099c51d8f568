// Cones put in place by a macro in a loop.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#macro Pin(Where, Height) cone { Where, 0.3, Where + Height*y, 0.05 pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } } #end
#declare I = 0;
#while (I < 4)
  Pin(<I - 1.5, -1, 0.2*I>, 0.5 + 0.4*I)
  #declare I = I + 1;
#end
