// A sweep modelled in tenths of millimetres: roots of its polynomial of degree 10, and the spheres at its joints.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 0.6, -7>*1e-4 look_at 0 angle 52 }
light_source { <-6, 9, -8>*1e-4 rgb 1 }
background { rgb <0.3, 0.4, 0.5> }
sphere_sweep {
  cubic_spline 8, <-3, -2, 0>, 0.1, <-2, 0.2, 0.2>, 0.4, <-1, -1, -0.3>, 0.6, <-0.3, 0.9, 0>, 0.3, <0.6, -0.6, 0.4>, 0.5,
  <1.2, 1.1, 0>, 0.4, <2.2, -0.4, 0.2>, 0.3, <3, -2, 0>, 0.1
  scale 1e-4 pigment { rgb <0.9, 0.6, 0.2> } finish { specular 0.4 }
}
