// Wine in a glass, larger than the glass is wide inside by a hundred-millionth: POV-Ray drops the second of two
// surfaces nearer than 0.0001 to each other, so that rays never leave the glass. Gap=0.002 makes both agree.
#version 3.7;
#ifndef (Gap) #declare Gap = 1e-8; #end
global_settings { assumed_gamma 1 max_trace_level 12 }
camera { location <0, 2, -6> look_at <0, 0.1, 0> angle 40 }
light_source { <5, 8, -6> rgb 1 }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.5, 0.6, 0.7>] [1 rgb <0.1, 0.2, 0.5>] } } }
plane { y, -1.3 pigment { checker rgb 0.8 rgb 0.3 } }
difference {
  cylinder { -1.2*y, 1.2*y, 1 }
  cylinder { -y, 1.3*y, 0.9 }
  pigment { rgbf 0.95 } finish { diffuse 0 specular 0.5 } interior { ior 1.5 }
}
cylinder {
  -(1 + Gap)*y, 0.6*y, 0.9 + Gap
  pigment { rgbf <0.9, 0.1, 0.2, 0.95> } finish { diffuse 0 reflection 0.1 } interior { ior 1.2 }
}
