// checker of colours; of pigments, turned.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { checker rgb <0.9, 0.8, 0.6>, rgb <0.3, 0.2, 0.4> scale 0.5 translate 0.01*z } finish { ambient 0.3 } }
sphere { 0, 1 pigment { checker pigment { rgb <0.8, 0.3, 0.2> } pigment { gradient x color_map { [0 rgb 0] [1 rgb 1] } scale 0.2 } scale 0.4 rotate <20, 30, 40> } translate x finish { ambient 0.3 } }
