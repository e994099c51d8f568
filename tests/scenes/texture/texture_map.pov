// texture_map blends whole shadings, finish and all.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { orthographic location <0, 0, -5> right 4*x up 3*y look_at 0 }
light_source { <2, 3, -10> rgb 0.9 }
plane { z, 0
  texture {
    gradient x
    texture_map {
      [0.3 pigment { rgb <0.8, 0.2, 0.2> } finish { phong 1 phong_size 10 }]
      [0.7 pigment { checker rgb 0.9, rgb 0.2 scale 0.3 translate 0.01*z } finish { ambient 0.6 }]
    }
    scale 4.01 translate -2*x
  }
}
