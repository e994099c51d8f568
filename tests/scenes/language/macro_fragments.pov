// Macros that give parts of a statement: numbers, vectors, modifiers, half an object.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#macro Three(A) A, A*2, A*3 #end
#macro Coat(C) pigment { C } finish { phong 0.6 } #end
#macro Open_Sphere(P, R) sphere { P, R #end
#macro Value(A) #local B = A + 1; B*0.5 #end
sphere { <Three(0.3)>*<-4, 0.5, 0.2>, Value(0.2) Coat(rgb <0.9, 0.4, 0.3>) }
Open_Sphere(<0.2, 0, 0>, 0.5) Coat(rgb <0.4, 0.8, 0.4>) }
box { 0, <Value(0), Value(1), 0.5> translate <1.1, -0.8, 0> Coat(rgb <0.4, 0.5, 0.9>) }
