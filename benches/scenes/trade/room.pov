// A room lit by a square lamp of 7x7 points: penumbras of furniture on floor and walls.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 }
#default { finish { ambient 0.15 diffuse 0.7 } }

camera { location <0, 1.5, -3.8> look_at <0, 1.1, 0> angle 62 }
light_source { <0.3, 2.9, 0> rgb 0.95 area_light 1.2 * x, 1.2 * z, 7, 7 }

// The room.
plane { y, 0
  pigment { checker rgb <0.66, 0.5, 0.36> rgb <0.6, 0.44, 0.3> scale 0.6 }
  finish { reflection 0.05 }
}
plane { -y, -3 pigment { rgb 0.85 } }
plane { -z, -2.5 pigment { rgb <0.8, 0.78, 0.7> } }
plane { x, -2.6 pigment { rgb <0.72, 0.3, 0.25> } }
plane { -x, -2.6 pigment { rgb <0.3, 0.45, 0.65> } }

// A table with a vase and a ball, a chair, a shelf.
union {
  box { <-0.9, 0.78, -0.5>, <0.9, 0.85, 0.5> }
  cylinder { <-0.8, 0, -0.4>, <-0.8, 0.78, -0.4>, 0.05 }
  cylinder { <0.8, 0, -0.4>, <0.8, 0.78, -0.4>, 0.05 }
  cylinder { <-0.8, 0, 0.4>, <-0.8, 0.78, 0.4>, 0.05 }
  cylinder { <0.8, 0, 0.4>, <0.8, 0.78, 0.4>, 0.05 }
  pigment { rgb <0.45, 0.28, 0.15> }
  translate <-0.2, 0, 0.6>
}
sphere { <-0.7, 1.1, 0.6>, 0.25 pigment { rgb 0.1 } finish { reflection 0.7 specular 0.5 roughness 0.01 } }
lathe {
  linear_spline 6, <0, 0.85>, <0.12, 0.85>, <0.2, 1.1>, <0.1, 1.35>, <0.13, 1.45>, <0.11, 1.45>
  translate <0.25, 0, 0.6>
  pigment { rgb <0.25, 0.4, 0.6> } finish { specular 0.5 roughness 0.02 }
}
union {
  box { <-0.3, 0.45, -0.3>, <0.3, 0.5, 0.3> }
  box { <-0.3, 0.5, 0.25>, <0.3, 1.1, 0.3> }
  #for (I, 0, 3) cylinder { <0.26, 0, 0.26>, <0.26, 0.45, 0.26>, 0.03 rotate 90 * I * y } #end
  rotate -30 * y translate <1.3, 0, -0.4>
  pigment { rgb <0.6, 0.2, 0.15> }
}
union {
  #for (I, 0, 3) box { <-2.6, 0.5 + 0.5 * I, 1.9>, <-1.6, 0.54 + 0.5 * I, 2.5> } #end
  box { <-1.64, 0, 1.9>, <-1.6, 2.2, 2.5> }
  pigment { rgb <0.5, 0.4, 0.3> }
}
#for (I, 0, 7)
  box { <-2.5 + 0.11 * I, 1.04, 2.0>, <-2.42 + 0.11 * I, 1.36 + 0.05 * mod(I * 3, 4), 2.4>
    pigment { rgb <0.3 + 0.15 * mod(I, 4), 0.2 + 0.2 * mod(I * 2, 3), 0.25 + 0.1 * mod(I * 5, 6)> } }
#end
