// Fog stirred by turbulence.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.2, -6> look_at <0, 0.6, 3> angle 55 }
light_source { <10, 15, -10> rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
fog { distance 12 rgb <0.8, 0.8, 0.85> turbulence 0.6 turb_depth 0.5 octaves 3 }
plane { y, -1 pigment { checker rgb <0.8, 0.7, 0.5>, rgb <0.4, 0.5, 0.3> } }
#declare I = 0;
#while (I < 6)
  cylinder { <1.6*I - 3, -1, 3*I>, <1.6*I - 3, 1.5, 3*I>, 0.4 pigment { rgb <0.8, 0.4, 0.3> } }
  #declare I = I + 1;
#end
