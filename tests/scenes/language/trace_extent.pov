// trace, inside and extents while the scene is read: pins on a shape.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Body = union { sphere { -0.7*x, 0.7 } torus { 0.6, 0.25 rotate 60*x translate 0.8*x } }
object { Body pigment { rgb <0.7, 0.6, 0.8> } }
#declare Low = min_extent(Body);
#declare High = max_extent(Body);
#for (I, 0, 1, 0.1)
  #declare Normal = <0, 0, 0>;
  #declare Foot = trace(Body, <Low.x + I*(High.x - Low.x), 2, -0.2>, -y, Normal);
  #if (vlength(Normal) != 0)
    cylinder { Foot, Foot + 0.4*Normal, 0.04 pigment { rgb <0.9, 0.3, 0.2> } }
  #end
#end
sphere { <0.8, -0.6, -1>, 0.1 + 0.2*inside(Body, <-0.7, 0.1, 0>) pigment { rgb <0.3, 0.8, 0.3> } }
