// Sphereflake for timing: nine children a sphere, each a third its size; reflection 0.5, three lights, level 6.
// Depth 2 to 6 (Declare=Depth=n, or -D Depth=n) makes 91, 820, 7,381, 66,430 and 597,871 spheres.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }

#ifndef (Depth) #declare Depth = 5; #end

camera { location <1.8, 1.6, -3.4> look_at <0, 0.1, 0> angle 44 }
light_source { <4, 6, -4> rgb 0.6 }
light_source { <-5, 3, -3> rgb 0.4 }
light_source { <1, 7, 3> rgb 0.4 }
background { rgb <0.1, 0.2, 0.4> }

#macro Flake(Centre, Radius, Up, Front, Level)
  sphere { Centre, Radius }
  #if (Level > 0)
    #local Side = vcross(Up, Front);
    #local I = 0;
    #while (I < 9)
      #if (I < 6)
        #local Out = cos(radians(60*I))*Front + sin(radians(60*I))*Side;
      #else
        #local Out = 0.57735*(cos(radians(120*I + 30))*Front + sin(radians(120*I + 30))*Side) + 0.81650*Up;
      #end
      Flake(Centre + Radius*4/3*Out, Radius/3, Out, vnormalize(vcross(Out, Up + 0.37*Front + 0.11*Side)), Level - 1)
      #local I = I + 1;
    #end
  #end
#end

union {
  Flake(<0, 0, 0>, 0.8, y, x, Depth)
  pigment { rgb <0.8, 0.6, 0.4> }
  finish { reflection 0.5 specular 0.5 }
  rotate <20, 0, -10>
}
plane { y, -1.3 pigment { rgb 0.6 } finish { reflection 0.5 } }
