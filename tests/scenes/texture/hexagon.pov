// hexagon of three colours in the xz plane, turned to the eye; on a sphere.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { hexagon rgb <0.8, 0.3, 0.3>, rgb <0.3, 0.7, 0.3>, rgb <0.3, 0.3, 0.8> scale 0.3 rotate 90*x } finish { ambient 0.3 } }
sphere { 0, 1 pigment { hexagon rgb <0.9, 0.8, 0.4>, rgb <0.5, 0.3, 0.2>, rgb <0.3, 0.5, 0.5> scale 0.25 rotate 30*x } translate x finish { ambient 0.3 } }
