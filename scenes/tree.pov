// A recursive macro: a tree of cones with leaves of smooth triangles, in autumn.

#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0.12 diffuse 0.75 } }

camera { location <0, 3.0, -10> look_at <0, 2.75, 0> angle 42 }
light_source { <-14, 13, -12> rgb <1.15, 1.05, 0.9> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.85, 0.88, 0.9>] [0.6 rgb <0.35, 0.55, 0.85>] } } }
plane { y, 0 pigment { bozo turbulence 0.5 scale 0.6 color_map { [0 rgb <0.20, 0.30, 0.08>] [1 rgb <0.38, 0.36, 0.12>] } } normal { bumps 0.5 scale 0.08 } }

#declare Stream = seed(31415);
#declare Leaf = mesh {
  smooth_triangle { 0, <0, 0.2, -1>, <0.08, 0.14, 0>, <0.6, 0.1, -1>, 0.32*y, <0, -0.3, -1> }
  smooth_triangle { 0, <0, 0.2, -1>, <-0.08, 0.14, 0>, <-0.6, 0.1, -1>, 0.32*y, <0, -0.3, -1> }
}
#macro Branch(From, Direction, Radius, Level)
  #local To = From + Direction;
  cone { From, Radius, To, 0.68*Radius pigment { rgb <0.26, 0.17, 0.11> } }
  #if (Level > 0)
    #for (I, 0, 2)
      Branch(To, vaxis_rotate(vrotate(Direction, <24 + 14*rand(Stream), 0, 10*rand(Stream)>), Direction, 120*I + 60*rand(Stream))*(0.66 + 0.14*rand(Stream)), 0.62*Radius, Level - 1)
    #end
  #else
    #for (I, 0, 4)
      object {
        Leaf
        rotate <180*rand(Stream), 360*rand(Stream), 180*rand(Stream)>
        translate From + Direction*(0.2 + 0.9*rand(Stream))
        pigment { rgb <0.80 - 0.25*rand(Stream), 0.15 + 0.42*rand(Stream), 0.04> }
        finish { diffuse 0.6, 0.35 }
      }
    #end
  #end
#end
union { Branch(0, 1.35*y, 0.20, 5) }
#for (I, 0, 90)
  object { Leaf rotate <80 + 20*rand(Stream), 360*rand(Stream), 0> translate <(rand(Stream) - 0.5)*7, 0.04, -2.5 + 5*rand(Stream)> pigment { rgb <0.75 - 0.25*rand(Stream), 0.15 + 0.35*rand(Stream), 0.04> } }
#end
