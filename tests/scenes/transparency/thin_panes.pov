// Many panes one behind another: adc_bailout ends the ray.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 20 adc_bailout 0.02 }

camera { location <0, 1, -6> look_at 0 angle 46 }
light_source { <4, 7, -6> rgb 1 }
plane { y, -1 pigment { checker rgb 0.9, rgb <0.3, 0.3, 0.4> } }
plane { z, 6 pigment { gradient y color_map { [0 rgb <0.6, 0.7, 0.9>] [1 rgb <0.9, 0.6, 0.4>] } scale 1.5 } }
#declare I = 0;
#while (I < 12)
  box { <-1.5 + 0.2*I, -1, 0.3*I - 2>, <0.2*I, 0.8, 0.3*I - 1.98> pigment { rgbt <0.3, 0.6, 0.4, 0.75> } }
  #declare I = I + 1;
#end
