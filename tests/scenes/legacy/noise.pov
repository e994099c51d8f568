// The first noise generator by #version 3.1.
#version 3.1;

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { z, 0 pigment { bozo scale 0.4 color_map { [0.0 color rgb 0.1] [1.0 color rgb 0.9] } } finish { ambient 0.5 } }
sphere { <0, 0, -1>, 0.9 pigment { granite color_map { [0.0 color rgb 0.1] [1.0 color rgb 1] } } finish { ambient 0.5 } }
