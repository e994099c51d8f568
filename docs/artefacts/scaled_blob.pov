// A blob modelled in millimetres.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7>/1000 look_at 0 angle 34 }
light_source { <-6, 9, -8>/1000 rgb 1 }
background { rgb <0.3, 0.4, 0.5> }
blob {
  threshold 0.5
  sphere { <-0.8, -0.3, 0>/1000, 1.3/1000, 1 } sphere { <0.8, -0.3, 0.2>/1000, 1.2/1000, 1 } sphere { <0, 0.9, 0>/1000, 1.1/1000, 1 }
  pigment { rgb <0.9, 0.6, 0.2> } finish { specular 0.4 }
}
plane { y, -1.3/1000 pigment { rgb 0.7 } }
