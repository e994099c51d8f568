// A mesh made in a loop: low hills from a sum of sines and noise, each triangle flat.

#version 3.7;
#include "functions.inc"
global_settings { assumed_gamma 1 }

camera { location <0, 4.6, -9.5> look_at <0, 0.4, 0> angle 44 }
light_source { <-14, 9, -3> rgb <1.2, 1.08, 0.9> }
light_source { <10, 10, -12> rgb <0.10, 0.13, 0.2> shadowless }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.95, 0.85, 0.75>] [0.5 rgb <0.35, 0.55, 0.85>] } } }

#declare Height = function (x, z) {
  2.4*f_noise3d(0.45*x + 3, 0.5, 0.45*z + 1) + 0.7*f_noise3d(1.3*x, 4, 1.3*z) + 0.2*f_noise3d(3.1*x, 8, 3.1*z) - 1.5 - 0.02*z*z*0.2
}
#declare Steps = 44;
mesh {
  #for (I, 0, Steps - 1)
    #for (J, 0, Steps - 1)
      #local X = -6.6 + 13.2*I/Steps;
      #local Z = -9 + 16*J/Steps;
      #local A = <X, Height(X, Z), Z>;
      #local B = <X + 13.2/Steps, Height(X + 13.2/Steps, Z), Z>;
      #local C = <X + 13.2/Steps, Height(X + 13.2/Steps, Z + 16/Steps), Z + 16/Steps>;
      #local D = <X, Height(X, Z + 16/Steps), Z + 16/Steps>;
      triangle { A, B, C }
      triangle { A, C, D }
    #end
  #end
  pigment {
    gradient y
    color_map { [0.00 rgb <0.20, 0.32, 0.10>] [0.35 rgb <0.30, 0.42, 0.14>] [0.5 rgb <0.46, 0.36, 0.24>] [0.72 rgb <0.50, 0.44, 0.38>] [0.78 rgb 0.95] [1 rgb 1] }
    scale 2.3 translate -0.9*y
  }
  finish { ambient 0.08 diffuse 0.85 }
}
plane { y, -0.28 pigment { rgb <0.02, 0.10, 0.16> } normal { bumps 0.04 scale 0.2 } finish { ambient 0.1 specular 0.5 roughness 0.01 reflection { 0.1, 0.8 falloff 3 } } }
