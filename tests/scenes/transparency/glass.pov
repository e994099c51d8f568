// Glass balls of three indices.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -6> look_at 0 angle 46 }
light_source { <4, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.3, 0.4> } }
plane { z, 6 pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.9, 0.6, 0.4>] } scale 1.5 } }
#declare I = 0;
#while (I < 3)
  sphere { <2*(I - 1), 0, 0>, 0.85 pigment { rgbf <0.95, 1, 0.95, 0.9> } finish { phong 0.8 ambient 0 diffuse 0.05 reflection 0.08 } interior { ior 1 + 0.25*I } }
  #declare I = I + 1;
#end
