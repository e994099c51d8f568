// A macro that calls itself: a tree of cylinders.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#macro Branch(From, Direction, Radius, Depth)
  #local To = From + Direction;
  cylinder { From, To, Radius }
  #if (Depth > 0)
    Branch(To, vrotate(Direction, <20, 40, 32>)*0.75, Radius*0.7, Depth - 1)
    Branch(To, vrotate(Direction, <-15, 80, -28>)*0.7, Radius*0.7, Depth - 1)
  #end
#end
union { Branch(-y, 0.7*y, 0.12, 5) pigment { rgb <0.6, 0.5, 0.3> } }
