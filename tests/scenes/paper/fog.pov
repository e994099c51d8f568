// Fog of distance 3 before walls at depth 1, 2, ... 8: a wall at depth d keeps exp(-d/3) of its own white.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location 0 right 4*x up 3*y look_at z }
fog { distance 3 rgb 0 }
#declare I = 0;
#while (I < 8)
  box { <-2 + I/2, -3, I + 1>, <-1.5 + I/2, 3, I + 1.5> pigment { rgb 1 } finish { emission 1 ambient 0 diffuse 0 } }
  #declare I = I + 1;
#end
