// Layered textures: sea, land, ice and clouds, one over the other, on a single sphere; a moon beside it.

#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 0.4, -5.6> look_at <0.15, 0, 0> angle 34 }
light_source { <-12, 5, -9> rgb <1.3, 1.22, 1.1> }
background { rgb <0.002, 0.003, 0.008> }

sphere {
  0, 1.35
  texture {
    pigment { bozo turbulence 0.3 scale 0.5 color_map { [0 rgb <0.01, 0.05, 0.18>] [1 rgb <0.02, 0.12, 0.30>] } }
    finish { ambient 0 diffuse 0.8 specular 0.35 roughness 0.04 }
  }
  texture {
    pigment {
      bozo turbulence 0.7 octaves 6 omega 0.55
      color_map {
        [0.00 rgbt 1] [0.50 rgbt <0.1, 0.2, 0.1, 1>] [0.51 rgbt <0.32, 0.30, 0.14, 0.05>]
        [0.62 rgbt <0.10, 0.24, 0.06, 0>] [0.80 rgbt <0.36, 0.26, 0.12, 0>] [1 rgbt <0.60, 0.52, 0.40, 0>]
      }
      scale 0.75 translate <0.4, 0.2, 0.1>
    }
    finish { ambient 0 diffuse 0.8 }
  }
  texture {
    pigment { gradient y turbulence 0.12 color_map { [0 rgbt <1, 1, 1, 0>] [0.08 rgbt <1, 1, 1, 0.1>] [0.13 rgbt 1] [0.87 rgbt 1] [0.92 rgbt <1, 1, 1, 0.1>] [1 rgbt <1, 1, 1, 0>] } scale 2.75 translate -1.375*y }
    finish { ambient 0 diffuse 0.85 }
  }
  texture {
    pigment {
      wrinkles turbulence 0.6 octaves 5
      color_map { [0.45 rgbt <1, 1, 1, 1>] [0.65 rgbt <1, 1, 1, 0.5>] [0.9 rgbt <1, 1, 1, 0.05>] }
      scale <0.7, 0.3, 0.7> rotate 15*z
    }
    finish { ambient 0 diffuse 0.9 }
  }
  rotate <12, -20, 18>
}
sphere {
  <1.75, 0.85, 1.4>, 0.30
  pigment { granite color_map { [0 rgb <0.25, 0.24, 0.22>] [1 rgb <0.6, 0.58, 0.54>] } }
  normal { dents 0.6 scale 0.08 }
  finish { ambient 0 diffuse 0.8 }
}
#declare Stream = seed(9);
#for (I, 0, 260)
  sphere { <(rand(Stream) - 0.5)*30, (rand(Stream) - 0.5)*22, 30>, 0.012 + 0.035*pow(rand(Stream), 4) pigment { rgb <0.8 + 0.2*rand(Stream), 0.85, 0.8 + 0.2*rand(Stream)> } finish { emission 1 diffuse 0 } }
#end
