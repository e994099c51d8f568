// An identifier as an argument is passed by reference, an expression by value.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Place = <-1.5, 0, 0>;
#macro Next(P, Step) #declare P = P + Step; #end
#declare I = 0;
#while (I < 4)
  sphere { Place, 0.35 pigment { rgb <0.9 - I*0.2, 0.4, 0.3 + I*0.2> } }
  Next(Place, <1, 0.25, 0>)
  Next((Place), <100, 0, 0>)
  #declare I = I + 1;
#end
