// A torus written out as a quartic, modelled in tens of micrometres: the coefficients are small, not zero.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <1, 3, -6>*1e-5 look_at 0 angle 24 }
light_source { <-6, 9, -8>*1e-5 rgb 1 }
background { rgb <0.3, 0.4, 0.5> }
#declare U = 1e-5;
quartic {
  <1,0,0,0, 2,0,0,2,0, -2.32*U*U, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0, 1.68*U*U, 0,0,0,0, 1,0, -2.32*U*U, 0, 0.7056*U*U*U*U>
  pigment { rgb <0.9, 0.6, 0.2> } finish { specular 0.4 }
}
