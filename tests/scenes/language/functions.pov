// Functions in expressions: a surface of beads.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Bump = function (x, z) { 0.8*exp(-(x*x + z*z)) - 0.3*sin(2*x)*cos(3*z) }
#declare Twice = function { Bump(x, z)*2 + y }
#for (I, -2, 2, 0.25)
  #for (J, -1, 1, 0.25)
    sphere { <I, Bump(I, J) - 0.3, J>, 0.13 pigment { rgb <0.5 + Twice(I, 0, J)/3, 0.5, 0.6> } }
  #end
#end
