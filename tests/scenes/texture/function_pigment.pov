// A pigment made of a function.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
#declare Rings = function (x, y) { 0.5 + 0.5*sin(12*sqrt(x*x + y*y)) }
plane { z, 0
  pigment { function { Rings(x - 0.5, y)*Rings(x + 0.5, y) } color_map { [0 rgb 0.03] [1 rgb 1] } }
  finish { ambient 0.4 }
}
