// One pattern all over the picture. Surface: 1 granite, 2 wood with turbulence of ten octaves, 3 crackle,
// 4 bozo, 5 agate, 6 marble with turbulence, 7 bumps, 8 wrinkles, 9 mandel, 10 three transparent layers.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Surface) #declare Surface = 1; #end
camera { orthographic location -10*z look_at 0 right 4*x up 3*y }
#declare Greys = color_map { [0 rgb 0] [1 rgb 1] }
plane { z, 0
  texture {
    #switch (Surface)
      #case (1) pigment { granite color_map { Greys } } #break
      #case (2) pigment { wood turbulence 0.1 octaves 10 scale 0.3 } #break
      #case (3) pigment { crackle color_map { Greys } scale 0.2 } #break
      #case (4) pigment { bozo color_map { Greys } scale 0.1 } #break
      #case (5) pigment { agate } #break
      #case (6) pigment { marble turbulence 1 } #break
      #case (7) pigment { rgb 1 } normal { bumps 0.5 scale 0.1 } #break
      #case (8) pigment { rgb 1 } normal { wrinkles 0.5 scale 0.3 } #break
      #case (9) pigment { mandel 200 } #break
      #case (10)
        pigment { granite color_map { Greys } }
      }
      texture { pigment { bozo color_map { [0 rgbt 1] [1 rgbt <0.5, 0.2, 0.1, 0.4>] } scale 0.2 turbulence 0.3 } }
      texture { pigment { wood turbulence 0.1 color_map { [0 rgbt <0.8, 0.7, 0.4, 0.5>] [1 rgbt 1] } scale 0.4 }
      #break
    #end
  }
  finish { ambient 0.5 diffuse 0.5 }
}
light_source { <3, 5, -10>, 1 }
