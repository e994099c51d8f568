// The movement of a watch: brass wheels under a bridge, blued screws, rubies, and a balance with its spiral.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 7 }
#default { finish { ambient 0.03 } }

camera { location <-1.6, 9.2, -7.4> look_at <0.1, 0, -0.25> angle 36 }

light_source { <-7, 10, -5> rgb <1.05, 0.97, 0.85> area_light <2, 0, 1.5>, <0, 2, 0>, 5, 5 adaptive 1 }
light_source { <9, 8, 4> rgb <0.22, 0.28, 0.40> }

// What the metal sees: a bright soft sky above, dark below.
sky_sphere {
  pigment {
    gradient y
    color_map { [0 rgb <0.05, 0.05, 0.07>] [0.35 rgb <0.10, 0.11, 0.14>] [0.60 rgb <0.72, 0.70, 0.66>] [0.74 rgb <0.13, 0.14, 0.17>] [0.9 rgb <0.10, 0.11, 0.14>] [1 rgb <0.45, 0.46, 0.5>] }
    rotate <20, 0, 15>
  }
}

#declare Brass = texture {
  pigment { rgb <0.72, 0.47, 0.17> }
  finish { diffuse 0.42 specular 0.8 roughness 0.02 metallic brilliance 2 reflection { 0.30 metallic } }
}
#declare Steel = texture {
  pigment { rgb <0.45, 0.46, 0.49> }
  finish { diffuse 0.30 specular 0.9 roughness 0.008 metallic reflection 0.45 }
}
#declare Blued = texture {
  pigment { rgb <0.04, 0.07, 0.35> }
  finish { diffuse 0.5 specular 1 roughness 0.01 metallic reflection { 0.35 metallic 0.5 } }
}
#declare Ruby = material {
  texture { pigment { rgbf <0.85, 0.05, 0.16, 0.5> } finish { diffuse 0.5 specular 1 roughness 0.004 reflection 0.18 } }
  interior { ior 1.77 }
}
// Stripes across the plates, as watchmakers grind them.
#declare Plate = texture {
  pigment { rgb <0.34, 0.33, 0.32> }
  normal { gradient x 0.30 slope_map { [0 <0, 0.9>] [0.5 <0.5, 0>] [1 <0, -0.9>] } scale 0.42 rotate 32*y }
  finish { diffuse 0.5 specular 0.5 roughness 0.04 metallic reflection 0.16 }
}

// A wheel of Count teeth about y, its rim at Radius, with spokes.
#macro Wheel(Count, Radius, Spokes)
  #local Thick = 0.09;
  #local Tooth = pi*Radius/Count*0.5;
  union {
    difference {
      cylinder { -Thick*y, Thick*y, Radius }
      cylinder { -2*Thick*y, 2*Thick*y, Radius*0.80 }
    }
    #for (I, 0, Count - 1)
      intersection {
        box { <Radius - 0.05, -Thick, -Tooth>, <Radius + 3.2*Tooth, Thick, Tooth> }
        plane { x, 0 rotate 24*y translate <Radius + 2.2*Tooth, 0, Tooth> }
        plane { x, 0 rotate -24*y translate <Radius + 2.2*Tooth, 0, -Tooth> }
        bounded_by { box { <Radius - 0.06, -0.1, -Tooth - 0.01>, <Radius + 3.2*Tooth, 0.1, Tooth + 0.01> } }
        rotate 360*I/Count*y
      }
    #end
    #for (I, 0, Spokes - 1)
      box { <0, -Thick*0.8, -Radius*0.05>, <Radius*0.85, Thick*0.8, Radius*0.05> rotate 360*I/Spokes*y }
    #end
    difference {
      cylinder { -Thick*1.1*y, Thick*1.1*y, Radius*0.2 }
      cylinder { -y, y, Radius*0.07 }
    }
  }
#end

// A pinion on its arbor.
#macro Arbor(Low, High, Radius, Leaves)
  union {
    cylinder { Low*y, High*y, Radius*0.35 }
    #for (I, 0, Leaves - 1)
      cylinder { <Radius*0.75, Low*0.4, 0>, <Radius*0.75, High*0.55, 0>, Radius*0.26 rotate 360*I/Leaves*y }
    #end
    cone { High*y, Radius*0.33, (High + 0.12)*y, Radius*0.12 }
  }
#end

#macro Screw(Place)
  difference {
    union { cylinder { 0, 0.10*y, 0.19 } torus { 0.15, 0.04 translate 0.10*y } cylinder { 0.1*y, 0.14*y, 0.15 } }
    box { <-0.3, 0.08, -0.025>, <0.3, 0.3, 0.025> rotate (Place.x*77 + Place.z*31)*y }
    texture { Blued }
    translate Place
  }
#end

#macro Jewel(Place)
  union {
    difference {
      cylinder { -0.03*y, 0.05*y, 0.20 }
      sphere { 0.16*y, 0.16 }
      material { Ruby }
    }
    torus { 0.225, 0.035 translate 0.03*y texture { Brass } }
    translate Place
  }
#end

// Base plate, with its rim and a groove.
difference {
  cylinder { -0.9*y, -0.5*y, 4.1 }
  torus { 3.75, 0.05 translate -0.5*y }
  cylinder { <1.85, -0.62, -1.35>, <1.85, 0, -1.35>, 1.62 }
  texture { Plate }
}
torus { 4.1, 0.14 translate -0.62*y texture { Brass } }
plane { y, -1 pigment { rgb <0.018, 0.020, 0.028> } finish { diffuse 0.8 specular 0.2 roughness 0.05 reflection { 0.01, 0.3 } } }

// The train.
object { Wheel(64, 1.72, 5) texture { Brass } translate <-1.45, -0.05, -0.55> }
object { Arbor(-0.5, 0.62, 0.30, 9) texture { Steel } translate <-1.45, 0, -0.55> }
object { Wheel(52, 1.20, 4) rotate 11*y texture { Brass } translate <0.28, 0.20, 0.95> }
object { Arbor(-0.5, 0.72, 0.22, 8) texture { Steel } translate <0.28, 0, 0.95> }
object { Wheel(44, 0.92, 4) rotate 5*y texture { Brass } translate <-1.75, 0.26, 2.05> }
object { Arbor(-0.5, 0.72, 0.20, 8) texture { Steel } translate <-1.75, 0, 2.05> }
object { Wheel(15, 0.60, 3) rotate 15*y texture { Steel } translate <1.72, -0.06, 1.55> }
object { Arbor(-0.5, 0.70, 0.16, 7) texture { Steel } translate <1.72, 0, 1.55> }

// Balance: rim, two arms, timing screws, and the spiral above it.
union {
  difference {
    cylinder { -0.10*y, 0.10*y, 1.32 }
    cylinder { -y, y, 1.14 }
  }
  box { <-1.2, -0.06, -0.09>, <1.2, 0.06, 0.09> }
  cylinder { -0.08*y, 0.08*y, 0.22 }
  #for (I, 0, 13)
    cylinder { 1.3*x, 1.45*x, 0.065 rotate (360*I/14 + 7)*y }
  #end
  rotate 38*y
  texture { Brass }
  translate <1.85, -0.12, -1.35>
}
union {
  #for (I, 0, 5)
    #local R = 0.24 + 0.115*I;
    torus { R, 0.014 clipped_by { plane { z, 0 } } }
    torus { R + 0.0575, 0.014 clipped_by { plane { -z, 0 } } translate 0.0575*x }
  #end
  rotate 20*y
  texture { Blued }
  translate <1.85, 0.16, -1.35>
}
object { Arbor(-0.5, 0.30, 0.16, 3) texture { Steel } translate <1.85, 0, -1.35> }

// Bridges: one over the train, one (a cock) over the balance.
#macro Bar(A, B, W)
  #local Along = B - A;
  box { <0, 0.60, -W>, <vlength(Along), 0.78, W> rotate degrees(atan2(-Along.z, Along.x))*y translate A }
#end
union {
  Bar(<0.28, 0, 0.95>, <0.05, 0, 3.05>, 0.40)
  Bar(<-1.75, 0, 2.05>, <0.05, 0, 3.05>, 0.36)
  Bar(<1.72, 0, 1.55>, <0.05, 0, 3.05>, 0.34)
  cylinder { <0.28, 0.60, 0.95>, <0.28, 0.78, 0.95>, 0.48 }
  cylinder { <-1.75, 0.60, 2.05>, <-1.75, 0.78, 2.05>, 0.46 }
  cylinder { <1.72, 0.60, 1.55>, <1.72, 0.78, 1.55>, 0.44 }
  cylinder { <0.05, -0.5, 3.05>, <0.05, 0.78, 3.05>, 0.60 }
  texture { Plate }
}
union {
  Bar(<1.85, 0, -1.35>, <3.45, 0, -0.35>, 0.24)
  cylinder { <1.85, 0.60, -1.35>, <1.85, 0.78, -1.35>, 0.40 }
  cylinder { <3.45, -0.5, -0.35>, <3.45, 0.78, -0.35>, 0.42 }
  translate -0.22*y
  texture { Plate rotate 70*y }
}

// Jewels and screws.
Jewel(<0.28, 0.78, 0.95>)
Jewel(<-1.75, 0.78, 2.05>)
Jewel(<1.72, 0.78, 1.55>)
Jewel(<1.85, 0.56, -1.35>)
Screw(<0.05, 0.77, 3.05>)
Screw(<3.45, 0.55, -0.35>)
Screw(<-3.35, -0.51, 0.95>)
Screw(<-0.35, -0.51, -3.35>)
Screw(<-2.6, -0.51, -2.35>)
Screw(<3.3, -0.51, 1.5>)
