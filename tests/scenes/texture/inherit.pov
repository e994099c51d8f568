// A texture by name, then changed field by field: what is not named stays.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
#declare Base = texture { pigment { gradient x color_map { [0 rgb <0.9, 0.3, 0.2>] [1 rgb 1] } scale 0.4 } finish { phong 0.8 } }
sphere { <-2.1, 0, 0>, 0.9 texture { Base } }
sphere { 0, 0.9 texture { Base pigment { gradient y } finish { ambient 0.4 } } }
sphere { <2.1, 0, 0>, 0.9 texture { Base rotate 45*z scale 0.5 } }
