// The same triangles one by one.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare M = union { triangle { <-0.9, -0.6, 0>, <0.9, -0.6, 0>, <0, 0.9, 0.3> } triangle { <-0.9, -0.6, 0>, <0.9, -0.6, 0>, <0, -0.4, 1> } }
object { M translate -x pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
object { M rotate 60*y translate x pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
