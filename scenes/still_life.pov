// Still life with glass: a wine glass, a carafe, an apple and a pear of wax, by the light of one window.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 9 adc_bailout 1/64 }
#default { finish { ambient 0.05 } }

camera { location <0.9, 3.6, -10.2> look_at <0.28, 1.50, -0.2> angle 34 }

// The window: an area light to the left, and what the room gives back.
light_source {
  <-8, 8.5, -4> rgb <1.25, 1.10, 0.90>
  area_light <2.4, 0, -2.4>, <0, 3, 0>, 4, 4 adaptive 0
}
light_source { <9, 6, -9> rgb <0.14, 0.16, 0.20> shadowless }

// The room, seen only by the glass: a window with four panes on the left, dark walls.
box { <-14, 0, -16>, <14, 14, 9> hollow inverse
  pigment { rgb <0.20, 0.15, 0.12> } finish { ambient 0.25 diffuse 0.5 } no_shadow no_image }
union {
  #for (I, 0, 1) #for (J, 0, 1)
    box { <-13.9, 5.2 + 2.3*J, -6.4 + 2.6*I>, <-13.8, 7.3 + 2.3*J, -4.1 + 2.6*I> }
  #end #end
  pigment { rgb <1, 0.97, 0.9> } finish { emission 4 } no_shadow
}

// Table and wall.
plane {
  y, 0
  pigment {
    wood turbulence 0.06 omega 0.4
    color_map {
      [0.0 rgb <0.33, 0.17, 0.09>] [0.5 rgb <0.25, 0.115, 0.055>] [0.8 rgb <0.18, 0.08, 0.04>] [1.0 rgb <0.30, 0.15, 0.08>]
    }
    rotate 3*x scale <0.22, 0.22, 1> rotate 82*y translate <3, 0, 0.4>
  }
  finish { specular 0.25 roughness 0.03 reflection { 0.02, 0.25 } }
}
plane {
  z, 5.5
  pigment {
    bozo turbulence 0.5 scale 2.4
    color_map { [0 rgb <0.105, 0.115, 0.085>] [1 rgb <0.165, 0.165, 0.115>] }
  }
}

#declare Clear_Glass = material {
  texture {
    pigment { rgbf <0.98, 0.995, 0.985, 0.97> }
    finish { ambient 0 diffuse 0.01 specular 0.9 roughness 0.001 reflection { 0.02, 0.9 fresnel } conserve_energy }
  }
  interior { ior 1.48 }
}
#declare Wine = material {
  texture { pigment { rgbf <0.62, 0.05, 0.09, 0.9> } finish { ambient 0 diffuse 0.06 specular 0.5 roughness 0.002 reflection { 0, 0.4 fresnel } } }
  interior { ior 1.34 fade_distance 0.9 fade_power 1 fade_color <0.45, 0.02, 0.05> }
}

// Wine glass: bowl, stem, foot.
#declare Bowl_Out = intersection { sphere { 0, 0.82 scale <1, 1.28, 1> } plane { y, 0.55 } }
#declare Bowl_In = sphere { 0, 0.785 scale <1, 1.28, 1> }
#declare Wine_Glass = union {
  merge {
    difference { object { Bowl_Out } object { Bowl_In } translate 2.5*y }
    cone { <0, 1.5, 0>, 0.11, <0, 0.95, 0>, 0.065 }
    cylinder { <0, 0.95, 0>, <0, 0.35, 0>, 0.065 }
    cone { <0, 0.35, 0>, 0.065, <0, 0.09, 0>, 0.2 }
    cylinder { <0, 0.02, 0>, <0, 0.07, 0>, 0.72 }
    torus { 0.70, 0.035 translate 0.045*y }
    cone { <0, 0.16, 0>, 0.1, <0, 0.06, 0>, 0.66 }
    material { Clear_Glass }
  }
  intersection {
    sphere { 0, 0.78 scale <1, 1.28, 1> }
    plane { y, -0.05 }
    translate 2.5*y
    material { Wine }
  }
}
object { Wine_Glass translate <-1.45, 0, 0.25> }

// Carafe: a body, a neck and a lip, hollow, with water.
#declare Hollow = merge {
  sphere { 0, 1 scale <1, 0.92, 1> translate 1.02*y }
  cone { <0, 1.5, 0>, 0.80, <0, 2.45, 0>, 0.29 }
  cone { <0, 2.44, 0>, 0.29, <0, 3.4, 0>, 0.42 }
}
difference {
  merge {
    object { Hollow scale <1.05, 1.02, 1.05> }
    cylinder { <0, 0.02, 0>, <0, 0.3, 0>, 0.66 }
    torus { 0.43, 0.045 translate 3.42*y }
  }
  object { Hollow }
  plane { -y, -3.47 }
  material { Clear_Glass }
  translate <1.1, 0.02, 0.75>
}
intersection {
  object { Hollow scale 0.998 translate 0.003*y }
  plane { y, 1.35 }
  texture { pigment { rgbf <0.97, 0.99, 1, 0.98> } finish { ambient 0 diffuse 0 specular 0.4 roughness 0.002 reflection { 0, 0.5 fresnel } } }
  interior { ior 1.33 }
  translate <1.1, 0.02, 0.75>
}

// An apple: a torus that closes in the middle.
union {
  torus { 0.34, 0.42 scale <1, 1.08, 1>
    texture {
      pigment {
        radial turbulence 0.25 frequency 7
        color_map { [0 rgb <0.42, 0.02, 0.02>] [0.35 rgb <0.50, 0.05, 0.03>] [0.7 rgb <0.62, 0.17, 0.05>] [1 rgb <0.42, 0.02, 0.02>] }
      }
      finish { specular 0.5 roughness 0.02 reflection { 0, 0.15 } }
    }
    texture {
      pigment { gradient y color_map { [0 rgbt <0.5, 0.45, 0.1, 1>] [0.75 rgbt <0.5, 0.45, 0.1, 1>] [1 rgbt <0.55, 0.48, 0.12, 0.25>] } scale 0.98 translate -0.5*y }
      finish { specular 0.3 roughness 0.03 }
    }
  }
  cone { <0, 0.18, 0>, 0.045, <0.10, 0.66, 0.02>, 0.03 pigment { rgb <0.12, 0.07, 0.03> } }
  rotate <8, 0, -12>
  translate <-0.25, 0.45, -1.55>
}

// A pear.
merge {
  sphere { <0, 0.52, 0>, 0.56 }
  cone { <0, 0.78, 0>, 0.497, <0, 1.30, 0>, 0.255 }
  sphere { <0, 1.25, 0>, 0.262 }
  cone { <0, 1.45, 0>, 0.035, <0.12, 1.82, 0.03>, 0.03 }
  pigment {
    bozo turbulence 0.6 scale 0.35
    color_map { [0 rgb <0.55, 0.50, 0.12>] [0.6 rgb <0.58, 0.46, 0.10>] [1 rgb <0.50, 0.28, 0.08>] }
  }
  finish { specular 0.3 roughness 0.04 reflection { 0, 0.08 } }
  rotate <0, 40, -9>
  translate <2.25, 0, -0.95>
}

// Grapes, heaped: a layer on the table, a smaller one in its hollows, one on top.
#declare Stream = seed(41);
#macro Grape(Place)
  sphere {
    Place + 0.05*<rand(Stream) - 0.5, 0, rand(Stream) - 0.5>, 0.175
    texture {
      pigment { rgbf <0.42, 0.58, 0.20, 0.55> }
      finish { ambient 0 diffuse 0.45 specular 0.6 roughness 0.008 reflection { 0, 0.25 } }
    }
    interior { ior 1.15 }
  }
#end
union {
  #for (I, 0, 3) #for (J, 0, 2) Grape(<0.34*I + 0.17*mod(J, 2), 0.175, 0.30*J>) #end #end
  #for (I, 0, 2) #for (J, 0, 1) Grape(<0.17 + 0.34*I + 0.17*mod(J, 2), 0.45, 0.17 + 0.30*J>) #end #end
  #for (I, 0, 1) Grape(<0.42 + 0.34*I, 0.72, 0.30>) #end
  rotate -14*y
  translate <0.55, 0, -1.9>
}
