// Parallel light, as from the sun: a sundial at three in the afternoon.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.12 diffuse 0.75 } }

camera { location <3.4, 4.8, -5.2> look_at <0, 0.15, 0> angle 42 }
light_source { <-60, 52, -6> rgb <1.1, 1.0, 0.82> parallel point_at 0 }
background { rgb <0.4, 0.55, 0.8> }

#declare Marble = pigment {
  marble turbulence 0.8 octaves 5
  color_map { [0 rgb <0.85, 0.83, 0.78>] [0.75 rgb <0.80, 0.77, 0.72>] [1 rgb <0.50, 0.48, 0.47>] }
  rotate 30*y scale 0.9
}
plane { y, -0.6 pigment { bozo turbulence 0.4 scale 0.2 color_map { [0 rgb <0.16, 0.30, 0.08>] [1 rgb <0.30, 0.45, 0.14>] } } }
difference {
  union {
    cylinder { -0.6*y, 0, 2.1 }
    torus { 2.1, 0.08 translate -0.08*y }
  }
  torus { 1.95, 0.025 }
  torus { 1.35, 0.02 }
  #for (Hour, -6, 6)
    box { <-0.025, -0.03, 1.45>, <0.025, 0.1, 1.85 + 0.06*(mod(Hour + 6, 3) = 0)> rotate 15*Hour*y }
  #end
  pigment { Marble }
}
// The gnomon's upper edge leans along the axis of the earth, here 48 degrees up.
intersection {
  box { <-0.06, 0, -1.25>, <0.06, 2, 0.7> }
  plane { <0, cos(radians(48)), -sin(radians(48))>, 0 translate -1.2*z }
  pigment { rgb <0.55, 0.33, 0.12> }
  finish { specular 0.6 roughness 0.03 metallic }
}
