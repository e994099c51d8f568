// What structures for objects are good for: Kind chooses the scene, N the number of objects.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Kind) #declare Kind = 5; #end
#ifndef (N) #declare N = 1000; #end
#declare S = seed(7);

camera { location <0, 1.2, -2.6> look_at <0, -0.1, 0> angle 45 }
light_source { <5, 8, -6> rgb 1 }
background { rgb <0.3, 0.4, 0.6> }
#macro Colour() texture { pigment { rgb <0.2 + 0.8*rand(S), 0.2 + 0.8*rand(S), 0.2 + 0.8*rand(S)> } } #end
#macro Ball(Place, Radius) sphere { Place, Radius Colour() } #end
// Even in a cube from -1 to 1.
#macro Anywhere() <2*rand(S) - 1, 2*rand(S) - 1, 2*rand(S) - 1> #end

#switch (Kind)
  // So many spheres on a plane.
  #case (1)
    plane { y, -0.5 pigment { checker rgb 1 rgb 0.3 scale 0.2 } }
    #for (I, 1, N)
      Ball(<2*rand(S) - 1, -0.3, 2*rand(S) - 1>, 0.2)
    #end
  #break
  // A cloud as even as chance makes it.
  #case (2)
    #for (I, 1, N)
      Ball(Anywhere(), 0.5 / pow(N, 1/3) * rand(S))
    #end
  #break
  // Hills of N triangles that are objects of their own.
  #case (3)
    #declare Side = int(sqrt(N / 2));
    #declare H = function (x, z) { 0.15 * sin(5*x) * cos(4*z) + 0.05 * sin(17*x + 9*z) }
    #macro P(I, J)
      <2*I/Side - 1, H(2*I/Side - 1, 2*J/Side - 1), 2*J/Side - 1>
    #end
    #for (I, 0, Side - 1)
      #for (J, 0, Side - 1)
        triangle { P(I, J), P(I + 1, J), P(I, J + 1) pigment { rgb <0.4, 0.7, 0.3> } }
        triangle { P(I + 1, J + 1), P(I + 1, J), P(I, J + 1) pigment { rgb <0.5, 0.6, 0.3> } }
      #end
    #end
  #break
  // Sizes and places over eight powers of ten, below a sky.
  #case (4)
    sphere { 0, 1e4 pigment { rgb <0.5, 0.6, 0.9> } finish { emission 1 diffuse 0 } hollow no_shadow }
    #for (I, 1, N)
      #declare Scale = pow(10, -4 * rand(S));
      Ball(Scale * Anywhere() * 1.5, 0.1 * Scale * rand(S))
    #end
  #break
  // A small heap in a wide ring of seats: the teapot in the stadium.
  #case (5)
    #for (I, 1, N / 10)
      #declare Angle = 2 * pi * rand(S);
      #declare Away = 300 + 100 * rand(S);
      box { -1, 1 scale 2 translate <Away * cos(Angle), (Away - 300) * 0.5, Away * sin(Angle)> Colour() }
    #end
    #for (I, 1, N - N / 10)
      Ball(Anywhere() * 0.6, 0.5 / pow(N, 1/3) * rand(S))
    #end
  #break
#end
