// The same box from six planes.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
intersection {
  plane { x, 0.8 } plane { -x, 0.9 } plane { y, 0.9 } plane { -y, 0.7 } plane { z, 0.6 } plane { -z, 0.5 }
  rotate <20, 30, 10> pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 }
}
