// #while with a changing radius.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare R = 0.6;
#declare X = -2;
#while (R > 0.05)
  sphere { <X + R, R - 1, 0>, R pigment { rgb <R + 0.3, 0.5, 1 - R> } }
  #declare X = X + 2*R;
  #declare R = R*0.8;
#end
