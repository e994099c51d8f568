// A polygon with a hole, in a slanting plane.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
polygon {
  11,
  <-1, -1>, <1.2, -1>, <1.5, 0.5>, <0, 1.4>, <-1.2, 0.6>, <-1, -1>,
  <-0.4, -0.4>, <0.5, -0.5>, <0.4, 0.5>, <-0.3, 0.3>, <-0.4, -0.4>
  rotate <30, 25, 10>
  pigment { rgb <0.5, 0.7, 0.9> }
}
