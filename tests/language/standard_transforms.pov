// transforms.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#include "transforms.inc"
#macro On(T) ShowV(vtransform(<1, 2, 3>, T)) #end
On(transform { Axis_Rotate_Trans(<1, 1, 1>, 40) }) On(transform { Shear_Trans(x, y+x, z) }) On(transform { Matrix_Trans(x, y, z, <1, 2, 3>) }) On(transform { Rotate_Around_Trans(90*y, x) }) On(transform { Reorient_Trans(x, y) }) On(transform { Point_At_Trans(<1, 1, 1>) }) On(transform { Axial_Scale_Trans(y, 2) }) ShowV(vinv_transform(<1, 2, 3>, transform { translate x scale 2 })) ShowV(vtransform(x, transform { rotate 90*z }))

sphere { 0, 1 }
