// The sky in a mirror, and fog on the way to it.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.2, -6> look_at <0, 0.6, 3> angle 55 }
light_source { <10, 15, -10> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.8, 0.6>] [1 rgb <0.2, 0.3, 0.7>] } } }
fog { distance 25 rgb <0.7, 0.75, 0.8> }
sphere { <1.5, 0.4, -1>, 1 pigment { rgb 0.1 } finish { reflection 0.8 diffuse 0.2 } }
plane { y, -1 pigment { checker rgb <0.8, 0.7, 0.5>, rgb <0.4, 0.5, 0.3> } }
#declare I = 0;
#while (I < 6)
  cylinder { <1.6*I - 3, -1, 3*I>, <1.6*I - 3, 1.5, 3*I>, 0.4 pigment { rgb <0.8, 0.4, 0.3> } }
  #declare I = I + 1;
#end
