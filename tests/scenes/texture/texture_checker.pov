// Textures in a checker, a brick and a hexagon.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.7, 1.5, 1> texture { checker texture { pigment { rgb <0.8, 0.3, 0.2> } } texture { pigment { rgb 0.9 } finish { phong 1 } } scale 0.4 translate 0.01*z } }
box { <-0.6, -1.5, 0>, <0.6, 1.5, 1> texture { brick texture { pigment { rgb 0.7 } }, texture { pigment { rgb <0.6, 0.3, 0.2> } } scale 0.08 translate 0.01*z } }
box { <0.7, -1.5, 0>, <2, 1.5, 1> texture { hexagon texture { pigment { rgb <0.8, 0.3, 0.2> } } texture { pigment { rgb <0.2, 0.6, 0.2> } } texture { pigment { rgb <0.2, 0.3, 0.8> } } scale 0.25 rotate 90*x } }
