// Ground fog among bare trees: each trunk is a few cones, placed by a random stream.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.1 diffuse 0.7 } }

camera { location <0, 1.7, -10> look_at <0, 2.2, 0> angle 56 }
light_source { <-40, 25, 30> rgb <1.2, 0.95, 0.7> parallel point_at 0 }
light_source { <10, 20, -30> rgb <0.18, 0.22, 0.30> shadowless }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.98, 0.82, 0.62>] [0.35 rgb <0.62, 0.70, 0.80>] [1 rgb <0.25, 0.40, 0.65>] } } }
fog { distance 55 rgb <0.82, 0.76, 0.68> }
fog { fog_type 2 distance 7 rgb <0.88, 0.84, 0.78> fog_offset 0.1 fog_alt 0.55 }

plane {
  y, 0
  pigment { bozo turbulence 0.6 scale 0.8 color_map { [0 rgb <0.22, 0.16, 0.07>] [0.6 rgb <0.30, 0.17, 0.06>] [1 rgb <0.18, 0.22, 0.07>] } }
  normal { bumps 0.4 scale 0.1 }
}

#declare Stream = seed(2718);
#macro Twig(From, Direction, Radius, Depth)
  #local To = From + Direction;
  cone { From, Radius, To, Radius*0.72 }
  #if (Depth > 0)
    Twig(To, vrotate(Direction, <20*rand(Stream) - 10, 360*rand(Stream), 14 + 16*rand(Stream)>)*(0.74 + 0.12*rand(Stream)), Radius*0.70, Depth - 1)
    Twig(To, vrotate(Direction, <20*rand(Stream) - 10, 360*rand(Stream), -14 - 18*rand(Stream)>)*(0.66 + 0.14*rand(Stream)), Radius*0.62, Depth - 1)
  #end
#end
#for (I, 0, 25)
  #local Z = -4 + 1.35*I;
  #local X = (rand(Stream) - 0.5)*(9 + 0.75*I);
  union {
    Twig(0, <0.25*(rand(Stream) - 0.5), 1.5 + 0.6*rand(Stream), 0>, 0.17 + 0.06*rand(Stream), 5)
    pigment { rgb <0.16, 0.11, 0.08> }
    translate <X + select(abs(X) - 1.2, 2.4*(X < 0 ? -1 : 1), 0), 0, Z>
  }
#end
