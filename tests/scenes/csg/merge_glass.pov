// Merge has no surfaces inside; union (right) shows them through glass.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Glass = material { texture { pigment { rgbf <0.9, 1, 0.95, 0.8> } finish { phong 0.6 } } interior { ior 1.2 } }
merge { sphere { <-1.5, 0, 0>, 0.6 } sphere { <-0.9, 0.1, 0>, 0.6 } material { Glass } }
union { sphere { <0.9, 0, 0>, 0.6 } sphere { <1.5, 0.1, 0>, 0.6 } material { Glass } }
