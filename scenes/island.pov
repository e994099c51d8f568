// A sky sphere of two layers, a gradient and clouds, over a rocky island in the sea.

#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -13> look_at <0, 2.4, 0> angle 55 }
light_source { <40, 32, -30> rgb <1.2, 1.12, 1.0> parallel point_at 0 }

sky_sphere {
  pigment { gradient y color_map { [0 rgb <0.62, 0.76, 0.92>] [0.25 rgb <0.30, 0.50, 0.85>] [0.8 rgb <0.06, 0.18, 0.52>] } }
  pigment {
    wrinkles turbulence 0.65 octaves 6 omega 0.6 lambda 2.3
    color_map { [0.35 rgbt <1, 1, 1, 1>] [0.55 rgbt <1, 1, 1, 0.45>] [0.80 rgbt <0.97, 0.97, 0.98, 0.05>] [1 rgbt <0.85, 0.87, 0.90, 0>] }
    scale <0.55, 0.14, 0.5> translate <0.2, 0, 0.3>
  }
}
plane {
  y, 0
  pigment { rgb <0.01, 0.07, 0.11> }
  normal { waves 0.18 frequency 2.5 turbulence 0.3 scale <1.4, 1, 0.8> }
  finish { ambient 0.1 diffuse 0.5 specular 0.6 roughness 0.01 reflection { 0.05, 0.8 falloff 3 } }
}
#declare Stream = seed(77);
union {
  #for (I, 0, 60)
    #local Far = sqrt(rand(Stream));
    #local Turn = 360*rand(Stream);
    box {
      -0.5, 0.5
      scale <0.9, 0.8 + 2.6*(1 - Far)*(1 - Far), 0.9>*(0.45 + 0.6*rand(Stream))
      rotate <20*rand(Stream), 90*rand(Stream), 20*rand(Stream)>
      translate vrotate(<3.0*Far, 0.55*(1 - Far), 0>, Turn*y)
    }
  #end
  pigment { granite scale 2 turbulence 0.3 color_map { [0 rgb <0.35, 0.29, 0.24>] [0.5 rgb <0.47, 0.41, 0.34>] [1 rgb <0.62, 0.56, 0.47>] } }
  normal { granite 0.35 scale 0.8 }
  finish { ambient 0.12 diffuse 0.75 }
}
// A light house.
union {
  cone { 0.6*y, 0.42, 3.9*y, 0.27 pigment { gradient y color_map { [0.5 rgb <0.92, 0.90, 0.86>] [0.5 rgb <0.72, 0.10, 0.08>] } scale 1.1 } }
  cylinder { 3.9*y, 4.0*y, 0.42 pigment { rgb 0.15 } }
  cylinder { 4.0*y, 4.45*y, 0.2 pigment { rgbf <1, 0.95, 0.7, 0.5> } finish { emission 0.5 } }
  cone { 4.45*y, 0.3, 4.85*y, 0 pigment { rgb <0.25, 0.08, 0.07> } }
  finish { ambient 0.12 diffuse 0.8 }
  translate <0.5, 0, 0.6>
}
