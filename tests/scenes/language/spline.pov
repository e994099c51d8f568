// A spline of three kinds, as a path of beads.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Path = spline { natural_spline 0, <-2, -0.6, 0> 0.3, <-1, 0.8, 0.5> 0.6, <0.6, -0.5, -0.4> 1, <2, 0.7, 0> }
#for (T, 0, 1, 0.04)
  sphere { Path(T), 0.12 pigment { rgb <0.9, 0.5, 0.2> } }
  sphere { Path(T, linear_spline), 0.07 pigment { rgb <0.3, 0.8, 0.4> } }
  sphere { Path(T, quadratic_spline), 0.07 pigment { rgb <0.3, 0.4, 0.9> } }
#end
