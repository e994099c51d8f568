// A mesh with an inside_vector takes part in a difference.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Gem = mesh {
  #local Turn = 0;
  #while (Turn < 4)
    triangle { y, vrotate(x, 90*Turn*y), vrotate(x, 90*(Turn + 1)*y) }
    triangle { -y, vrotate(x, 90*Turn*y), vrotate(x, 90*(Turn + 1)*y) }
    #local Turn = Turn + 1;
  #end
  inside_vector <0.1, 1, 0.2>
}
difference { sphere { 0, 0.9 } object { Gem scale 1.1 translate <0.3, 0.7, -0.6> } pigment { rgb <0.5, 0.7, 0.9> } }
