// #read takes numbers, vectors and strings from a file until it ends.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#fopen Data "points.txt" read
#while (defined(Data))
  #read (Data, Name, Place, Radius)
  sphere { Place, Radius pigment { rgb #if (strcmp(Name, "red") = 0) <0.9, 0.2, 0.2> #else <0.2, 0.4, 0.9> #end } }
#end
