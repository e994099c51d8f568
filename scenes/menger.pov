// A Menger sponge of three generations, by difference: rods along the axes taken from a cube.

#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <2.9, 2.3, -3.8> look_at <0, -0.08, 0> angle 45 }
light_source { <1.5, 6, -5> rgb <1.05, 0.98, 0.88> }
light_source { <7, 1, -1> rgb <0.25, 0.30, 0.42> }
background { rgb <0.05, 0.06, 0.09> }

#declare Rods = union {
  #for (Level, 1, 3)
    #local Count = pow(3, Level - 1);
    #local Half = 1/pow(3, Level);
    #for (I, 0, Count - 1)
      #for (J, 0, Count - 1)
        #local U = -1 + (2*I + 1)/Count;
        #local V = -1 + (2*J + 1)/Count;
        box { <U - Half, V - Half, -1.01>, <U + Half, V + Half, 1.01> }
        box { <U - Half, -1.01, V - Half>, <U + Half, 1.01, V + Half> }
        box { <-1.01, U - Half, V - Half>, <1.01, U + Half, V + Half> }
      #end
    #end
  #end
}

difference {
  box { -1, 1 }
  object { Rods }
  pigment { gradient y color_map { [0 rgb <0.55, 0.20, 0.12>] [1 rgb <0.95, 0.75, 0.38>] } scale 2.02 translate -1.01*y }
  finish { ambient 0.06 diffuse 0.8 }
}
plane { y, -1.001 pigment { rgb <0.10, 0.11, 0.13> } finish { reflection { 0.05, 0.4 } } }
