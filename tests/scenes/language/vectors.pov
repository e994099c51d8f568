// Vectors of two to five components, promoted, picked apart, compared.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare A = <1, 2>;
#declare B = <0.1, 0.2, 0.3> + A*0.1;
#declare C = <1, 2, 3, 4, 5>/5;
sphere { B*<-6, 1, 1>, vlength(B) pigment { rgb <C.x, C.y, C.z> } }
sphere { vrotate(x, 35*z), 0.4 pigment { rgb <C.filter, C.y, 0.2> } }
sphere { vcross(x, vnormalize(<0, 1, 1>))*0.7 - 0.4*y, 0.3 pigment { rgb (B < A*0.2) + <0.2, 0.3, 0.4> } }
