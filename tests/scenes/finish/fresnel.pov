// Fresnel reflection by the index of refraction: 1.3, 1.7 and 3.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
#declare I = 0;
#while (I < 3)
  sphere {
    <2.1*(I - 1), 0, 0>, 0.95
    pigment { rgb <0.3, 0.1, 0.1> }
    finish { reflection { 1 fresnel } conserve_energy }
    interior { ior select(I - 1, 1.3, 1.7, 3) }
  }
  #declare I = I + 1;
#end
sky_sphere { pigment { gradient y color_map { [0 rgb 0.9] [1 rgb <0.2, 0.4, 0.8>] } } }
