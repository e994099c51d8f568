// A scene modelled in tens of micrometres: shadows, mirror and glass.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -7>*1e-5 look_at 0 angle 36 }
light_source { <-6, 9, -8>*1e-5 rgb 1 }
background { rgb <0.3, 0.4, 0.5> }
union {
  sphere { <-1, 0, 0>, 1 pigment { rgb 0.1 } finish { reflection 0.8 } }
  sphere { <1.1, -0.2, -0.5>, 0.8 pigment { rgbt 0.95 } finish { reflection 0.1 } interior { ior 1.4 } }
  torus { 0.6, 0.3 rotate 60*x translate <0.2, 1, 1> pigment { rgb <0.9, 0.6, 0.2> } }
  scale 1e-5
}
plane { y, -1e-5 pigment { checker rgb 0.9, rgb 0.5 scale 1e-5 } }
