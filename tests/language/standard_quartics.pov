// Where the surfaces of shapesq.inc have their insides; and the numbers of rad_def.inc's settings.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "shapes.inc"
#include "shapesq.inc"
#macro Insides(O, S)
  #local R = seed(5);
  #for (I, 1, 70)
    #debug str(inside(O, S*<rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>), 0, 0)
  #end
  #debug "\n"
#end
Insides(Bicorn, 4) Insides(Bicorn, 1.5)
Insides(Crossed_Trough, 4) Insides(Crossed_Trough, 1.5)
Insides(Cubic_Cylinder, 4) Insides(Cubic_Cylinder, 1.5)
Insides(Cubic_Saddle_1, 4) Insides(Cubic_Saddle_1, 1.5)
Insides(Devils_Curve, 4) Insides(Devils_Curve, 1.5)
Insides(Folium, 4) Insides(Folium, 1.5)
Insides(Glob_5, 4) Insides(Glob_5, 1.5)
Insides(Twin_Glob, 4) Insides(Twin_Glob, 1.5)
Insides(Helix, 4) Insides(Helix, 1.5)
Insides(Helix_1, 4) Insides(Helix_1, 1.5)
Insides(Hyperbolic_Torus_40_12, 30) Insides(Hyperbolic_Torus_40_12, 1.5)
Insides(Lemniscate, 4) Insides(Lemniscate, 1.5)
Insides(Quartic_Loop_1, 4) Insides(Quartic_Loop_1, 1.5)
Insides(Monkey_Saddle, 4) Insides(Monkey_Saddle, 1.5)
Insides(Parabolic_Torus_40_12, 30) Insides(Parabolic_Torus_40_12, 1.5)
Insides(Piriform, 4) Insides(Piriform, 1.5)
Insides(Quartic_Paraboloid, 4) Insides(Quartic_Paraboloid, 1.5)
Insides(Quartic_Cylinder, 4) Insides(Quartic_Cylinder, 1.5)
Insides(Steiner_Surface, 4) Insides(Steiner_Surface, 6)
Insides(Torus_40_12, 30) Insides(Torus_40_12, 1.5)
Insides(Witch_Hat, 4) Insides(Witch_Hat, 8)
Insides(Sinsurf, 4) Insides(Sinsurf, 1.5)
#include "rad_def.inc"
#debug concat(str(Radiosity_Default,0,0), str(Radiosity_Debug,0,0), str(Radiosity_Fast,0,0), "\n")
#debug concat(str(Radiosity_Normal,0,0), str(Radiosity_2Bounce,0,0), str(Radiosity_Final,0,0), "\n")
#debug concat(str(Radiosity_OutdoorLQ,0,0), str(Radiosity_OutdoorHQ,0,0), str(Radiosity_OutdoorLight,0,0), "\n")
#debug concat(str(Radiosity_IndoorLQ,0,0), str(Radiosity_IndoorHQ,0,0), "\n")
