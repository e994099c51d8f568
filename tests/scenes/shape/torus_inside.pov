// The camera is inside the tube of a torus.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0.2, -4> look_at <3, 0, -2.5> angle 80 }
light_source { <0.5, 0.5, -3.8> rgb 1 }
torus { 4, 1.2 pigment { checker rgb <0.9, 0.7, 0.4>, rgb <0.3, 0.4, 0.6> scale 0.7 } finish { ambient 0.3 } }
