// A sphereflake at dusk: every sphere carries nine of a third its size, five generations deep (7,381 spheres), over
// dark water. Colour goes by generation, so the youngest catch the light like frost.
//
// Depth may be set on the command line (Declare=Depth=5).

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 6 }
#default { finish { ambient 0 } }

#ifndef (Depth) #declare Depth = 4; #end

camera { location <3.3, 0.75, -6.2> look_at <0.05, -0.08, 0> angle 41 }

light_source { <-30, 22, -18> rgb <1.25, 0.92, 0.66> }
light_source { <24, 30, -30> rgb <0.20, 0.27, 0.42> }
light_source { <4, 3, 26> rgb <0.75, 0.42, 0.34> }

sky_sphere {
  pigment {
    gradient y
    color_map {
      [0.00 rgb <1.00, 0.55, 0.28>]
      [0.05 rgb <0.90, 0.42, 0.30>]
      [0.18 rgb <0.42, 0.26, 0.40>]
      [0.45 rgb <0.12, 0.13, 0.30>]
      [1.00 rgb <0.02, 0.03, 0.10>]
    }
  }
}

// Water: almost black from above, a mirror at a glance.
plane {
  y, -1.62
  pigment { rgb <0.010, 0.018, 0.030> }
  normal { waves 0.035 frequency 0.9 scale 0.9 }
  finish { diffuse 0.4 reflection { 0.03, 0.85 falloff 4 } }
}

#declare Coat = array[6] {
  texture { pigment { rgb <0.34, 0.08, 0.14> } finish { diffuse 0.5 specular 0.8 roughness 0.01 metallic reflection { 0.38 metallic 0.6 } } },
  texture { pigment { rgb <0.62, 0.20, 0.13> } finish { diffuse 0.5 specular 0.8 roughness 0.01 metallic reflection { 0.34 metallic 0.6 } } },
  texture { pigment { rgb <0.80, 0.42, 0.14> } finish { diffuse 0.5 specular 0.8 roughness 0.01 metallic reflection { 0.30 metallic 0.6 } } },
  texture { pigment { rgb <0.95, 0.72, 0.36> } finish { diffuse 0.6 specular 0.8 roughness 0.01 metallic reflection { 0.26 metallic 0.6 } } },
  texture { pigment { rgb <0.98, 0.90, 0.74> } finish { diffuse 0.7 specular 0.8 roughness 0.01 reflection 0.20 } },
  texture { pigment { rgb <0.95, 0.96, 1.00> } finish { diffuse 0.7 specular 0.8 roughness 0.01 reflection 0.20 } }
}

// Six children round the equator of the direction Up, three round its pole; Front is any unit vector across Up.
#macro Flake(Centre, Radius, Up, Front, Level)
  sphere { Centre, Radius texture { Coat[min(Depth - Level, 5)] } }
  #if (Level > 0)
    #local Side = vcross(Up, Front);
    #local Reach = Radius*4/3;
    #local I = 0;
    #while (I < 9)
      #if (I < 6)
        #local Turn = radians(60*I);
        #local Out = cos(Turn)*Front + sin(Turn)*Side;
      #else
        #local Turn = radians(120*(I - 6) + 30);
        #local Out = sin(radians(35.26))*(cos(Turn)*Front + sin(Turn)*Side) + cos(radians(35.26))*Up;
      #end
      Flake(Centre + Reach*Out, Radius/3, Out, vnormalize(vcross(Out, Up + 0.37*Front + 0.11*Side)), Level - 1)
      #local I = I + 1;
    #end
  #end
#end

union { Flake(<0, 0, 0>, 1, y, x, Depth) rotate <-48, 24, 0> }
