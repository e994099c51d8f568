// Image maps wrapped round a sphere, a cylinder and a torus.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1, -7> look_at 0 angle 47 }
light_source { <5, 7, -7> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb <0.4, 0.4, 0.5> } }
sphere { <-2.1, 0, 0>, 0.9 pigment { image_map { png "card.png" map_type 1 interpolate 2 } } }
cylinder { -0.8*y, 0.8*y, 0.7 pigment { image_map { png "card.png" map_type 2 } translate -0.5*y scale <1, 1.6, 1> } }
torus { 0.6, 0.3 rotate -50*x pigment { image_map { png "card.png" map_type 5 } } translate 2.1*x }
