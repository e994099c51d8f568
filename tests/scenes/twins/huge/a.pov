// Everyday size.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare S = 1;
camera { location <0, 1.5, -5>*S look_at 0 angle 46 }
light_source { <4, 6, -5>*S rgb 1 }
union {
  plane { y, -1.003 pigment { checker rgb 0.8, rgb 0.4 translate 0.01 } }
  sphere { -0.9*x, 0.8 pigment { rgb <0.8, 0.4, 0.3> } finish { reflection 0.2 } }
  torus { 0.6, 0.25 rotate -50*x translate 0.9*x pigment { rgbf <0.9, 0.95, 1, 0.7> } interior { ior 1.3 } }
  difference { box { <-0.4, -1, -1.4>, <0.4, -0.4, -0.8> } sphere { <0, -0.4, -1.1>, 0.35 } pigment { rgb <0.3, 0.6, 0.4> } }
  scale S
}
