// rand and seed give the reference's own numbers.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Stream = seed(1234);
#declare I = 0;
#while (I < 60)
  sphere { <rand(Stream)*4 - 2, rand(Stream)*2 - 0.8, rand(Stream)*2>, 0.08 + 0.12*rand(Stream) pigment { rgb <rand(Stream), rand(Stream), rand(Stream)> } }
  #declare I = I + 1;
#end
