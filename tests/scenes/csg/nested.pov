// Difference of a union from an intersection, and what was cut put back smaller.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Cut = union { cylinder { -2*x, 2*x, 0.5 } cylinder { -2*y, 2*y, 0.5 } cylinder { -2*z, 2*z, 0.5 } }
#declare Core = intersection { box { -0.9, 0.9 } sphere { 0, 1.2 } }
union {
  difference { object { Core } object { Cut } pigment { rgb <0.8, 0.7, 0.5> } }
  intersection { object { Core scale 0.8 } object { Cut scale 0.9 } pigment { rgb <0.3, 0.5, 0.7> } }
  rotate <25, 30, 0>
}
