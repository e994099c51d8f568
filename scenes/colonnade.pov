// A colonnade at the edge of still water, early in the morning; mist lies on the water and thins with height.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
#default { finish { ambient 0.03 } }

camera { location <-5.2, 2.1, -13.5> look_at <1.5, 2.9, 4> angle 54 }

// A low sun on the left, and the sky's own light.
light_source { <-52, 15, 6> rgb <1.7, 1.02, 0.52> parallel point_at 0 }
light_source { <10, 40, -40> rgb <0.13, 0.17, 0.25> shadowless }

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.00 rgb <1.00, 0.60, 0.30>]
      [0.08 rgb <0.92, 0.56, 0.40>]
      [0.22 rgb <0.52, 0.46, 0.55>]
      [0.50 rgb <0.16, 0.24, 0.44>]
      [1.00 rgb <0.05, 0.10, 0.25>]
    }
  }
  pigment {
    bozo turbulence 0.7 omega 0.55 octaves 5
    color_map { [0.45 rgbt <1, 0.8, 0.7, 1>] [0.65 rgbt <1, 0.78, 0.66, 0.6>] [0.9 rgbt <1, 0.86, 0.76, 0.25>] }
    scale <0.7, 0.10, 0.35> rotate 12*z
  }
}

fog { fog_type 2 distance 42 rgb <0.80, 0.62, 0.54> fog_offset 0.05 fog_alt 0.45 }
fog { distance 300 rgbt <0.66, 0.52, 0.50, 0.62> }

// Water.
plane {
  y, 0
  pigment { rgb <0.03, 0.045, 0.05> }
  normal { bumps 0.06 scale <0.9, 1, 0.25> }
  finish { diffuse 0.3 specular 0.3 roughness 0.004 reflection { 0.05, 0.9 falloff 3 } }
}

#declare Stone = texture {
  pigment {
    granite turbulence 0.3 scale 2.2
    color_map { [0 rgb <0.62, 0.56, 0.48>] [0.5 rgb <0.70, 0.64, 0.55>] [1 rgb <0.56, 0.50, 0.42>] }
  }
  normal { granite 0.08 scale 0.5 }
  finish { diffuse 0.75 }
}

// A fluted column: a drum with sixteen hollows, on a base and under a capital.
#declare Shaft = difference {
  cone { 0, 0.50, 5*y, 0.42 }
  #for (I, 0, 15)
    cone { <0.52, 0.15, 0>, 0.075, <0.435, 4.85, 0>, 0.062 rotate 22.5*I*y }
  #end
  bounded_by { cylinder { 0, 5*y, 0.51 } }
}
#declare Column = union {
  box { <-0.70, 0, -0.70>, <0.70, 0.22, 0.70> }
  torus { 0.50, 0.12 translate 0.32*y }
  torus { 0.46, 0.07 translate 0.48*y }
  object { Shaft translate 0.5*y }
  torus { 0.43, 0.06 translate 5.50*y }
  cone { <0, 5.55, 0>, 0.42, <0, 5.85, 0>, 0.64 }
  box { <-0.68, 5.85, -0.68>, <0.68, 6.05, 0.68> }
}

#macro Row(Count, Step)
  union {
    #for (I, 0, Count - 1)
      object { Column translate I*Step*z }
    #end
    box { <-0.62, 6.05, -0.9>, <0.62, 6.55, (Count - 1)*Step + 0.9> }
    box { <-0.72, 6.55, -1.0>, <0.72, 6.72, (Count - 1)*Step + 1.0> }
    box { <-0.80, 6.72, -1.1>, <0.80, 6.95, (Count - 1)*Step + 1.1> }
    #for (I, 0, 2*Count - 2)
      box { <-0.66, 6.18, I*Step/2 - 0.18>, <0.66, 6.44, I*Step/2 + 0.18> }
    #end
    texture { Stone }
  }
#end

// The terrace with its steps into the water.
union {
  box { <0.6, -1, -4>, <30, 0.60, 70> }
  box { <0.2, -1, -4.4>, <30, 0.40, 70> }
  box { <-0.2, -1, -4.8>, <30, 0.20, 70> }
  texture { Stone }
}
object { Row(12, 3.6) translate <1.9, 0.6, -2.4> }
object { Row(12, 3.6) translate <8.3, 0.6, -2.4> }

// A dome far off, and hills.
union {
  cylinder { 0, 6*y, 7 }
  #for (I, 0, 17)
    cylinder { <7.4, 0, 0>, <7.4, 6, 0>, 0.35 rotate 20*I*y }
  #end
  cylinder { 6*y, 7*y, 8.1 }
  difference { sphere { 0, 6.6 scale <1, 0.9, 1> translate 7*y } plane { y, 7 } }
  sphere { 13.2*y, 0.7 }
  cone { 13.5*y, 0.2, 15.5*y, 0 }
  texture { Stone }
  translate <-22, 0, 62>
}
box { <-40, -1, 52>, <-8, 0.5, 76> texture { Stone } }
#for (I, 0, 6)
  sphere { 0, 1 scale <34 + 7*mod(I*5, 4), 9 + 4*mod(I*3, 5), 12> translate <-150 + 46*I, -2, 170 + 12*mod(I, 3)> pigment { rgb <0.10, 0.14, 0.13> } }
#end

// A boat at the steps, and three posts.
union {
  difference {
    intersection { sphere { 0, 1 scale <0.66, 0.62, 2.2> } plane { y, 0.10 } }
    sphere { 0, 1 scale <0.58, 0.55, 2.1> translate 0.05*y }
  }
  box { <-0.56, -0.02, -0.14>, <0.56, 0.03, 0.14> }
  box { <-0.50, -0.02, -1.04>, <0.50, 0.03, -0.80> }
  pigment { wood scale 0.12 turbulence 0.1 color_map { [0 rgb <0.22, 0.11, 0.06>] [1 rgb <0.34, 0.18, 0.09>] } }
  rotate -24*y
  translate <-2.5, 0.16, -3.2>
}
#for (I, 0, 2)
  cylinder { <-1.15 - 0.1*I, -1, 1.4 + 4.2*I>, <-1.1 - 0.1*I, 1.5, 1.4 + 4.2*I>, 0.11 pigment { rgb <0.16, 0.10, 0.07> } }
  sphere { <-1.1 - 0.1*I, 1.53, 1.4 + 4.2*I>, 0.16 pigment { rgb <0.5, 0.36, 0.2> } finish { specular 0.6 roughness 0.02 } }
#end
