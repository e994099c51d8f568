// Forty differences inside one another.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#macro Peel(N)
  #if (N = 0)
    sphere { 0, 1.2 }
  #else
    difference { Peel(N - 1) sphere { vrotate(1.25*x, <0, 47*N, 23*N>), 0.35 } }
  #end
#end
object { Peel(40) pigment { rgb <0.8, 0.5, 0.6> } }
