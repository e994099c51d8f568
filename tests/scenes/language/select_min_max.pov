// select, min, max, int, div, mod, abs, pow and comparison chains.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare I = -3;
#while (I <= 3)
  box {
    <-0.2, 0, -0.2>, <0.2, 0.2 + abs(I)*0.2, 0.2>
    translate <I*0.6, select(I, -1, -0.4, -0.7), 0>
    pigment { rgb <max(0.1, I/3), min(0.9, pow(1.3, I)), (mod(I + 4, 2) = 0 ? 0.8 : 0.2)> }
  }
  #declare I = I + 1;
#end
