// bozo.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
plane { z, 0 pigment { bozo color_map { [0 rgb 0.02] [0.5 rgb 0.3] [1 rgb 1] } scale 0.3 } finish { ambient 0.3 } }
