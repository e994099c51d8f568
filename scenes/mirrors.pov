// A hall of mirrors: three of them stand about a heap of balls, with ten reflections deep.

#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 10 adc_bailout 0.01 }

camera { location <0, 2.3, -4.6> look_at <0, 0.75, 0.3> angle 62 }
light_source { <-1.2, 5.2, -2.2> rgb <0.75, 0.70, 0.62> }
light_source { <2.5, 4.5, -3.5> rgb <0.25, 0.30, 0.40> }
sky_sphere { pigment { gradient y color_map { [0 rgb <0.45, 0.50, 0.60>] [1 rgb <0.10, 0.13, 0.25>] } } }

#declare Silver = texture { pigment { rgb <0.02, 0.03, 0.03> } finish { ambient 0 diffuse 0.1 reflection rgb <0.86, 0.89, 0.88> } }
#for (I, -1, 1)
  union {
    box { <-1.45, 0.06, 2.5>, <1.45, 3.3, 2.56> texture { Silver } }
    difference {
      box { <-1.55, 0, 2.47>, <1.55, 3.4, 2.6> }
      box { <-1.44, 0.07, 2.4>, <1.44, 3.29, 2.7> }
      pigment { rgb <0.45, 0.28, 0.08> } finish { specular 0.6 roughness 0.02 metallic }
    }
    rotate 64*I*y
  }
#end
plane { y, 0 pigment { checker rgb <0.75, 0.70, 0.62>, rgb <0.22, 0.16, 0.14> scale 0.5 } finish { ambient 0.1 } }

#declare Tints = array[5] { rgb <0.85, 0.20, 0.15>, rgb <0.95, 0.70, 0.15>, rgb <0.20, 0.55, 0.30>, rgb <0.18, 0.35, 0.75>, rgb <0.65, 0.30, 0.60> }
#for (I, 0, 4)
  sphere { vrotate(<0.72, 0.42, 0>, 72*I*y), 0.42 pigment { Tints[I] } finish { ambient 0.08 specular 0.7 roughness 0.01 reflection 0.08 } }
#end
sphere { 1.02*y, 0.42 pigment { rgb 0.9 } finish { ambient 0.08 specular 0.7 roughness 0.01 reflection 0.15 } }
