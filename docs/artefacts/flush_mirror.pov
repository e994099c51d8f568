// Mirrors that end exactly where a box of haze ends: their upper sides are drawn or not. Top=1.05 makes both agree.
#version 3.7;
#ifndef (Top) #declare Top = 1; #end
global_settings { assumed_gamma 1 }
camera { location <0, 7, -3> look_at 0 angle 40 }
light_source { <-4, 6, -2> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.2, 0, 0.4> } }
box {
  <-2.2, -0.1, -1.5>, <2.2, Top, 1.5> hollow pigment { rgbt 1 }
  interior { media { emission 0.05 } }
}
#declare I = -2;
#while (I <= 2)
  box {
    <-0.12, 0, -0.8>, <0.12, 1, 0.8> rotate (20*I + 10)*y translate 0.8*I*x
    pigment { rgbf <0, 1, 1, 0.3> } finish { ambient 0.2 diffuse 0.4 reflection <0.8, 0.1, 0.1> }
  }
  #declare I = I + 1;
#end
