// All ways to say a colour.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
#declare C = array[9];
#declare C[0] = rgb <0.8, 0.4, 0.2>;
#declare C[1] = color red 0.3 green 0.6 blue 0.9;
#declare C[2] = C[0]*0.5 + <0, 0.3, 0>;
#declare C[3] = srgb <0.5, 0.5, 0.9>;
#declare C[4] = color C[1] red 0.9;
#declare C[5] = rgb 0.6;
#declare C[6] = colour rgb <0.2, 0.5>;
#declare C[7] = rgbf <0.9, 0.9, 0.3, 0.5>;
#declare C[8] = rgb <0.3, 0.3, 0.3> transmit 0.5;
#declare I = 0;
#while (I < 9)
  sphere { <mod(I, 3) - 1, 1 - div(I, 3), 0>*0.95, 0.44 pigment { C[I] } }
  #declare I = I + 1;
#end
