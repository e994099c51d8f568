// A lathe of Bézier curves, modelled in tens of micrometres.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7>*1e-5 look_at 0 angle 32 }
light_source { <-6, 9, -8>*1e-5 rgb 1 }
background { rgb <0.3, 0.4, 0.5> }
lathe {
  bezier_spline 12, <0.1, -1.6>, <1.4, -1.5>, <0.3, -1>, <0.4, -0.5>, <0.4, -0.5>, <0.5, 0>, <1.6, 0.2>, <1.3, 0.9>,
  <1.3, 0.9>, <1.1, 1.4>, <0.6, 1.4>, <0.7, 1.7>
  scale 1e-5 pigment { rgb <0.9, 0.6, 0.2> } finish { specular 0.4 }
}
