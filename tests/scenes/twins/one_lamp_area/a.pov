// An area light of one lamp.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
light_source { <-3, 5, -4> rgb 0.7 area_light x, y, 1, 1 }
sphere { 0, 0.9 pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
