// Light filtered by coloured panes falls on the floor.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }
#default { finish { ambient 0.05 diffuse 0.8 } }

camera { location <2.4, 2.6, -7> look_at <-0.35, 1.5, 1> angle 48 }
light_source { <-9, 9.5, 17> rgb 3.2 parallel point_at <0, 1.4, 2.5> }
light_source { <4, 4, -7> rgb 0.3 shadowless }

background { rgb <0.75, 0.85, 1> }
plane { y, 0 pigment { rgb <0.80, 0.77, 0.72> } finish { reflection { 0, 0.15 } } }
difference {
  box { <-9, 0, 2.5>, <9, 9, 3> }
  union {
    box { <-1.5, 0.8, 2>, <1.5, 2.6, 4> }
    cylinder { <0, 2.6, 2>, <0, 2.6, 4>, 1.5 }
  }
  pigment { granite scale 1.5 color_map { [0 rgb <0.50, 0.47, 0.42>] [1 rgb <0.62, 0.58, 0.52>] } }
}
// Panes: a fan in the arch, squares below, each with lead round it.
#declare Tint = array[6] { rgbf <1, 0.12, 0.10, 0.95>, rgbf <1, 0.75, 0.08, 0.95>, rgbf <0.10, 0.75, 0.20, 0.95>, rgbf <0.10, 0.35, 1, 0.95>, rgbf <0.75, 0.15, 0.85, 0.95>, rgbf <0.20, 0.85, 0.90, 0.95> }
#for (I, 0, 4)
  #for (J, 0, 2)
    box { <-1.5 + 0.6*I, 0.8 + 0.6*J, 2.74>, <-0.9 + 0.6*I, 1.4 + 0.6*J, 2.76> pigment { Tint[mod(I + 2*J, 6)] } finish { ambient 0 diffuse 0.1 specular 0.3 } }
  #end
#end
#for (I, 0, 5)
  intersection {
    cylinder { 2.74*z, 2.76*z, 1.5 }
    plane { -y, 0 rotate 30*I*z }
    plane { y, 0 rotate 30*(I + 1)*z }
    translate 2.6*y
    pigment { Tint[I] }
    finish { ambient 0 diffuse 0.1 specular 0.3 }
  }
  cylinder { 0, 1.5*x, 0.03 rotate 30*I*z translate <0, 2.6, 2.75> pigment { rgb 0.05 } }
#end
#for (I, 0, 5) cylinder { <-1.5 + 0.6*I, 0.8, 2.75>, <-1.5 + 0.6*I, 2.6, 2.75>, 0.03 pigment { rgb 0.05 } } #end
#for (J, 0, 3) cylinder { <-1.5, 0.8 + 0.6*J, 2.75>, <1.5, 0.8 + 0.6*J, 2.75>, 0.03 pigment { rgb 0.05 } } #end
