// A negative scale mirrors shape and pattern.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Half = union {
  cone { 0, 0.5, <0.9, 0.8, 0>, 0.1 }
  sphere { <0.9, -0.4, 0>, 0.4 }
  pigment { gradient x color_map { [0 rgb <0.9, 0.3, 0.2>] [1 rgb <0.2, 0.3, 0.9>] } }
}
object { Half translate 0.3*x }
object { Half translate 0.3*x scale <-1, 1, 1> }
