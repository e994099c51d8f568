// The same in short, by name.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Paint = pigment { rgb <0.8, 0.5, 0.3> }
#declare Shine = finish { phong 0.5 }
sphere { -x, 0.8 pigment { Paint } finish { Shine } }
sphere { x, 0.8 pigment { checker rgb 1, rgb 0.2 scale 0.3 } }
