// A machine part by combination: flange, bolt holes, ribs, a shaft with keyway, gear teeth.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
#default { finish { ambient 0.1 diffuse 0.6 specular 0.5 roughness 0.02 reflection 0.12 } }

camera { location <3.4, 3.6, -5> look_at <0, 0.35, 0> angle 40 }
light_source { <-5, 9, -6> rgb 0.9 }
light_source { <7, 5, -3> rgb 0.35 }
plane { y, -0.5 pigment { checker rgb 0.55 rgb 0.4 scale 0.8 } finish { reflection 0.06 } }
background { rgb <0.3, 0.34, 0.4> }

#declare Steel = pigment { rgb <0.62, 0.64, 0.68> }
#declare Brass = pigment { rgb <0.75, 0.6, 0.28> }

// Flange with eight bolt holes.
difference {
  union { cylinder { <0, -0.5, 0>, <0, -0.2, 0>, 2 } cylinder { <0, -0.5, 0>, <0, 0.9, 0>, 1.05 } }
  cylinder { <0, -1, 0>, <0, 1.5, 0>, 0.7 }
  #for (I, 0, 7)
    union {
      cylinder { <1.55, -1, 0>, <1.55, 0, 0>, 0.17 }
      cone { <1.55, -0.3, 0>, 0.12, <1.55, -0.15, 0>, 0.28 }
      rotate 45 * I * y
    }
  #end
  torus { 1.05, 0.09 translate 0.65 * y }
  box { <-0.16, 0, -2>, <0.16, 0.45, 2> rotate 20 * y }
  pigment { Steel }
}

// Ribs.
#for (I, 0, 7)
  intersection {
    box { <0.9, -0.3, -0.06>, <1.9, 0.7, 0.06> }
    plane { <1, 1.1, 0>, 1.15 }
    rotate (45 * I + 22.5) * y
    pigment { Steel }
  }
#end

// Shaft with keyway and a gear at its end.
difference {
  union {
    cylinder { <0, -0.4, 0>, <0, 1.9, 0>, 0.6 }
    difference {
      cylinder { <0, 1.2, 0>, <0, 1.55, 0>, 1.2 }
      #for (I, 0, 23)
        box { <1.02, 1, -0.075>, <1.4, 1.7, 0.075> rotate 15 * I * y }
      #end
      #for (I, 0, 5)
        cylinder { <0.85, 1, 0>, <0.85, 1.7, 0>, 0.13 rotate 60 * I * y }
      #end
    }
  }
  box { <-0.12, 0.9, -0.9>, <0.12, 2.2, -0.4> }
  sphere { <0, 2.15, 0>, 0.45 }
  pigment { Brass }
}

// Bolts.
#for (I, 0, 7)
  #if (mod(I, 3) != 1)
    union {
      cylinder { <1.55, -0.5, 0>, <1.55, 0.02, 0>, 0.11 }
      intersection {
        cylinder { <1.55, -0.12, 0>, <1.55, 0.05, 0>, 0.24 }
        #for (K, 0, 2) box { <-0.19, -1, -1>, <0.19, 1, 1> rotate 60 * K * y translate 1.55 * x } #end
      }
      rotate 45 * I * y
      pigment { rgb 0.3 }
    }
  #end
#end
