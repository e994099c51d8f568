// A slab of ior 1.5, one unit thick and turned by 45 degrees about y, shifts what lies behind it, an edge at x = 0, by
// sin(45)(1 - cos(45)/sqrt(1.5^2 - sin(45)^2)) = 0.32920 along x.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { orthographic location -5*z right 4*x up 3*y look_at 0 }
box { <-6, -0.75, -0.5>, <6, 0.75, 0.5> rotate 45*y pigment { rgbf 1 } finish { ambient 0 diffuse 0 } interior { ior 1.5 } }
plane { -z, -4.5 pigment { gradient x color_map { [0.5 rgb 1] [0.5 rgb 0] } scale 40 translate -20*x } finish { emission 1 ambient 0 diffuse 0 } }
