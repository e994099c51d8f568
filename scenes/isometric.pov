// An orthographic camera looks on a small town: parallel lines stay parallel.

#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <20, 20, -20> right 12.8*x up 9.6*y look_at <0.4, 0.6, 0.4> }
light_source { <8, 30, -24> rgb 1.05 parallel point_at 0 }
light_source { <-20, 12, -10> rgb <0.15, 0.18, 0.25> shadowless }
#default { finish { ambient 0.12 diffuse 0.75 } }

plane { y, 0 pigment { rgb <0.55, 0.66, 0.50> } }
#declare Stream = seed(12);
#for (I, -4, 4)
  #for (J, -4, 4)
    #if (mod(I + 40, 3) != 0 & mod(J + 40, 3) != 0)
      #local High = 0.4 + 1.7*rand(Stream)*rand(Stream);
      #local Tint = rand(Stream);
      union {
        box { <-0.40, 0, -0.40>, <0.40, High, 0.40> pigment { rgb <0.88 - 0.25*Tint, 0.80 - 0.15*Tint, 0.66 + 0.14*Tint> } }
        #if (rand(Stream) < 0.6)
          intersection {
            plane { <1, 1.2, 0>, 0 translate <0.47, High, 0> }
            plane { <-1, 1.2, 0>, 0 translate <-0.47, High, 0> }
            plane { -y, -High } plane { z, 0.45 } plane { -z, 0.45 }
            bounded_by { box { <-0.48, High - 0.01, -0.46>, <0.48, High + 0.5, 0.46> } }
            pigment { rgb <0.70, 0.30 + 0.1*Tint, 0.22> }
            rotate 90*int(2*rand(Stream))*y
          }
        #else
          box { <-0.44, High, -0.44>, <0.44, High + 0.06, 0.44> pigment { rgb <0.45, 0.47, 0.52> } }
        #end
        #for (K, 0.22, High - 0.12, 0.32)
          box { <-0.26, K, -0.41>, <-0.08, K + 0.14, -0.3> pigment { rgb <0.20, 0.25, 0.34> } }
          box { <0.08, K, -0.41>, <0.26, K + 0.14, -0.3> pigment { rgb <0.20, 0.25, 0.34> } }
          box { <0.3, K, -0.26>, <0.41, K + 0.14, -0.08> pigment { rgb <0.20, 0.25, 0.34> } }
          box { <0.3, K, 0.08>, <0.41, K + 0.14, 0.26> pigment { rgb <0.20, 0.25, 0.34> } }
        #end
        translate <I, 0, J>
      }
    #else
      box { <I - 0.5, 0, J - 0.5>, <I + 0.5, 0.01, J + 0.5> pigment { rgb <0.62, 0.60, 0.56> } }
      #if (rand(Stream) < 0.35)
        union {
          cylinder { 0, 0.3*y, 0.05 pigment { rgb <0.35, 0.22, 0.12> } }
          sphere { 0.48*y, 0.24 pigment { rgb <0.18, 0.40, 0.16> } }
          translate <I + 0.3, 0, J + 0.3>
        }
      #end
    #end
  #end
#end
