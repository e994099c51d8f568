// Wires and a fence much thinner than a pixel, before sky and water.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.2 diffuse 0.8 } }

camera { location <0, 1.6, -9> look_at <0, 1.7, 0> angle 48 }
light_source { <-10, 14, -12> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.9, 0.92, 0.95>] [0.5 rgb <0.35, 0.5, 0.8>] } } }
plane { y, 0 pigment { rgb <0.25, 0.33, 0.22> } }

// Wires from mast to mast.
#for (I, 0, 5)
  #local Height = 2.1 + 0.28 * I;
  #for (K, -12, 11)
    #local A = 0.5 * K; #local B = 0.5 * (K + 1);
    cylinder { <A, Height + 0.012 * A * A, 2>, <B, Height + 0.012 * B * B, 2>, 0.004 pigment { rgb 0.05 } }
  #end
#end
cylinder { <-3.4, 0, 2>, <-3.4, 4.2, 2>, 0.03 pigment { rgb 0.15 } }
cylinder { <3.4, 0, 2>, <3.4, 4.2, 2>, 0.03 pigment { rgb 0.15 } }

// The fence: meshes that shrink into the distance.
#for (I, -60, 60)
  cylinder { <I * 0.1, 0, 0.4 + abs(I) * 0.06>, <I * 0.1, 0.9, 0.4 + abs(I) * 0.06>, 0.0035 pigment { rgb <0.8, 0.8, 0.75> } }
#end
#for (I, 0, 8)
  cylinder { <-6, 0.1 * I + 0.05, 4>, <0, 0.1 * I + 0.05, 0.4>, 0.003 pigment { rgb 0.7 } }
  cylinder { <6, 0.1 * I + 0.05, 4>, <0, 0.1 * I + 0.05, 0.4>, 0.003 pigment { rgb 0.7 } }
#end
sphere { <-1.2, 0.35, -1.5>, 0.35 pigment { rgb <0.7, 0.25, 0.2> } finish { specular 0.6 roughness 0.005 } }
