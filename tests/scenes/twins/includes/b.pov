// The same by hand: three boxes, twelve rods, eight balls.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
union {
  box { <-1, -0.8, -0.3>, <1, 0.4, 0.5> }
  box { <-0.8, -1, -0.3>, <0.8, 0.6, 0.5> }
  box { <-0.8, -0.8, -0.5>, <0.8, 0.4, 0.7> }
  #for (I, -1, 1, 2)
    #for (J, -1, 1, 2)
      cylinder { <-0.8, -0.2 + 0.6*I, 0.1 + 0.4*J>, <0.8, -0.2 + 0.6*I, 0.1 + 0.4*J>, 0.2 }
      cylinder { <0.8*I, -0.8, 0.1 + 0.4*J>, <0.8*I, 0.4, 0.1 + 0.4*J>, 0.2 }
      cylinder { <0.8*I, -0.2 + 0.6*J, -0.3>, <0.8*I, -0.2 + 0.6*J, 0.5>, 0.2 }
      #for (K, -1, 1, 2) sphere { <0.8*I, -0.2 + 0.6*J, 0.1 + 0.4*K>, 0.2 } #end
    #end
  #end
  pigment { rgb <0.137255, 0.419608, 0.556863> }
}
