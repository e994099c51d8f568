// Components by name.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare V = <1, 2, 3>; #declare W = <4, 5, 6, 7>; #declare U = <8, 9>; #declare C = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>;
Show(V.x) Show(V.y) Show(V.z) Show(V.red) Show(V.green) Show(V.blue) Show(V.u) Show(V.v) Show(W.t) Show(W.filter) Show(U.u) Show(U.v)
Show(C.red) Show(C.green) Show(C.blue) Show(C.filter) Show(C.transmit) Show(C.x) Show(C.t) Show(C.gray) Show(V.gray) Show(<1, 1, 1>.gray)
Show((V*2).y) Show((V+W).t) Show(V.x*V.y+V.z) Show(vcross(x, y).z) Show(<1, 2, 3>.z) Show(x.x+y.y+z.z)
#declare A = array[2]{<1, 2, 3>, <4, 5, 6>} Show(A[1].y) Show(A[0].z*2)

sphere { 0, 1 }
