// A sky sphere of two layers, scaled and turned: clouds over a gradient.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.2, -6> look_at <0, 0.6, 3> angle 55 }
light_source { <10, 15, -10> rgb 1 }
sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.7, 0.8, 1>] [1 rgb <0.1, 0.3, 0.8>] } }
  pigment { bozo turbulence 0.6 color_map { [0 rgbt 1] [0.5 rgbt <1, 1, 1, 0.9>] [0.9 rgbt <1, 1, 1, 0.1>] } scale <0.5, 0.15, 0.5> }
  rotate 20*z
}
plane { y, -1 pigment { checker rgb <0.8, 0.7, 0.5>, rgb <0.4, 0.5, 0.3> } }
#declare I = 0;
#while (I < 6)
  cylinder { <1.6*I - 3, -1, 3*I>, <1.6*I - 3, 1.5, 3*I>, 0.4 pigment { rgb <0.8, 0.4, 0.3> } }
  #declare I = I + 1;
#end
