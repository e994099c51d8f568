// Two dice by constructive solid geometry: a box met with a sphere, less its pips.

#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0.4, 3.6, -7> look_at <0, 0.85, 0> angle 41 }
light_source { <-5, 8, -6> rgb 1.1 area_light 2*x, 2*z, 4, 4 adaptive 1 }

plane { y, 0 pigment { rgb <0.06, 0.30, 0.16> } normal { bumps 0.25 scale 0.02 } finish { ambient 0.1 diffuse 0.8 } }

#macro Pips(Count)
  #if (mod(Count, 2) = 1) sphere { -1.06*z, 0.2 } #end
  #if (Count > 1) sphere { <-0.5, 0.5, -1.06>, 0.2 } sphere { <0.5, -0.5, -1.06>, 0.2 } #end
  #if (Count > 3) sphere { <0.5, 0.5, -1.06>, 0.2 } sphere { <-0.5, -0.5, -1.06>, 0.2 } #end
  #if (Count = 6) sphere { <-0.5, 0, -1.06>, 0.2 } sphere { <0.5, 0, -1.06>, 0.2 } #end
#end

#macro Die(Body, Pip)
  difference {
    intersection {
      box { -1, 1 }
      sphere { 0, 1.42 }
    }
    union {
      union { Pips(1) }
      union { Pips(2) rotate 90*y }
      union { Pips(3) rotate 90*x }
      union { Pips(4) rotate -90*x }
      union { Pips(5) rotate -90*y }
      union { Pips(6) rotate 180*y }
      pigment { Pip }
    }
    pigment { Body }
    finish { ambient 0.1 diffuse 0.7 specular 0.8 roughness 0.008 reflection { 0.02, 0.3 } }
  }
#end

object { Die(rgb <0.70, 0.07, 0.07>, rgb 0.95) rotate <0, 28, 0> translate <-1.35, 1, 0.3> }
object { Die(rgb <0.92, 0.90, 0.82>, rgb 0.05) rotate <90, 0, 0> rotate 62*y translate <1.35, 1, -0.2> }
