// A block of glass that stands on the floor exactly: which of the two surfaces a ray meets first is left to
// rounding in POV-Ray. Lift=0.05 makes both agree.
#version 3.7;
#ifndef (Lift) #declare Lift = 0; #end
global_settings { assumed_gamma 1 max_trace_level 15 }
camera { location <3, 2.5, -4> look_at <0, 0.5, 0> angle 36 }
light_source { <-5, 6, 4> rgb 1 }
cylinder { 0*y, 9*y, 30 pigment { rgb <0.98, 0.96, 0.9> } finish { diffuse 0.7 } hollow }
merge {
  box { <-1, 0, -0.3>, <1, 1, 0.3> }
  cylinder { <-1, 0, 0>, <-1, 1, 0>, 0.3 }
  cylinder { <1, 0, 0>, <1, 1, 0>, 0.3 }
  rotate 7*y translate Lift*y
  pigment { rgbf 1 } finish { diffuse 0 }
  interior { ior 1.5 fade_power 1001 fade_distance 1 fade_color <0.35, 0.65, 0.85> }
}
