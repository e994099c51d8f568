// warp repeat with flip; warp turbulence in world scale.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
box { <-2, -1.5, 0>, <-0.02, 1.5, 1> pigment { gradient <1, 1, 0> scale 0.5 color_map { [0 rgb <0.7, 0.2, 0.2>] [1 rgb 1] } warp { repeat 0.5*x flip x } warp { repeat 0.4*y } } finish { ambient 0.3 } }
sphere { 0, 1 pigment { gradient x scale 0.2 color_map { [0 rgb 0.1] [1 rgb 1] } warp { turbulence 0.4 octaves 3 } } translate x finish { ambient 0.3 } }
