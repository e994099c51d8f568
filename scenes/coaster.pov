// A path by spline: rails, sleepers and a train of balls along it.

#version 3.7;
#include "transforms.inc"
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.1 diffuse 0.75 specular 0.4 roughness 0.02 } }

camera { location <0, 6.2, -9.5> look_at <0, 1.0, 0> angle 46 }
light_source { <-8, 14, -6> rgb 1.05 }
background { rgb <0.55, 0.70, 0.85> }
plane { y, 0 pigment { checker rgb <0.50, 0.62, 0.42>, rgb <0.46, 0.58, 0.38> scale 1.5 } finish { specular 0 } }

#declare Way = spline {
  cubic_spline
  -0.15, <-4.2, 1.2, -0.6>
  0.00, <-3.4, 2.6, 1.6>  0.15, <-1.0, 0.8, 2.6>  0.30, <1.2, 1.9, 0.8>  0.45, <3.4, 0.7, 1.6>
  0.60, <3.8, 1.8, -1.4>  0.75, <1.0, 0.6, -2.2>  0.90, <-1.4, 1.6, -0.6>  1.05, <-3.9, 0.9, -1.9>
  1.20, <-3.4, 2.6, 1.6>  1.35, <-1.0, 0.8, 2.6>
}
#declare Count = 150;
#for (I, 0, Count - 1)
  #local T = 1.2*I/Count;
  #local U = 1.2*(I + 1)/Count;
  #local Here = Way(T);
  #local Next = Way(U);
  #local Side = 0.16*vnormalize(vcross(y, Next - Here));
  #local Next_Side = 0.16*vnormalize(vcross(y, Way(U + 0.008) - Next));
  cylinder { Here + Side, Next + Next_Side, 0.035 pigment { rgb <0.75, 0.12, 0.10> } }
  cylinder { Here - Side, Next - Next_Side, 0.035 pigment { rgb <0.75, 0.12, 0.10> } }
  sphere { Next + Next_Side, 0.035 pigment { rgb <0.75, 0.12, 0.10> } }
  sphere { Next - Next_Side, 0.035 pigment { rgb <0.75, 0.12, 0.10> } }
  cylinder { Here + 1.2*Side - 0.04*y, Here - 1.2*Side - 0.04*y, 0.02 pigment { rgb <0.85, 0.85, 0.80> } }
  #if (mod(I, 6) = 0)
    cylinder { Here - 0.05*y, <Here.x, 0, Here.z>, 0.03 pigment { rgb <0.60, 0.62, 0.66> } }
  #end
#end
#for (I, 0, 6)
  union {
    sphere { 0.22*y, 0.19 }
    torus { 0.12, 0.05 translate 0.06*y }
    Spline_Trans(Way, 0.34 + 0.033*I, y, 0.01, 0)
    pigment { rgb <0.95, 0.75 - 0.09*I, 0.15> }
    finish { specular 0.8 reflection 0.08 }
  }
#end
