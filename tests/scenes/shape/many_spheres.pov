// Three hundred spheres in a spiral: the tree at work.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 2.5, -6> look_at 0 angle 42 }
light_source { <4, 6, -5> rgb 1 }
#declare I = 0;
#while (I < 300)
  sphere {
    vrotate(<1.9*(1 - I/400), 0, 0>, 37.5*I*y) + (I/150 - 1)*y, 0.14
    pigment { rgb <0.5 + 0.5*sin(I/20), 0.5 + 0.4*sin(I/33), 0.5 + 0.5*cos(I/27)> }
  }
  #declare I = I + 1;
#end
