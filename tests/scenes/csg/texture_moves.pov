// A texture set before a transformation moves with the shape; one set after stays in the world.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
union {
  sphere { 0, 0.8 pigment { checker rgb 0.9, rgb <0.8, 0.2, 0.2> scale 0.5 } rotate 30*z translate -1.1*x }
  sphere { 0, 0.8 rotate 30*z translate 1.1*x pigment { checker rgb 0.9, rgb <0.2, 0.3, 0.8> scale 0.5 } }
  rotate 15*y
}
