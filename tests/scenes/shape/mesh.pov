// A mesh of plain triangles: an octahedron, twice, once turned.
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
}
object { Gem rotate 20*y translate -1.2*x pigment { rgb <0.9, 0.4, 0.5> } }
object { Gem scale <0.6, 1, 0.9> rotate <40, 10, 30> translate 1.2*x pigment { rgb <0.4, 0.8, 0.6> } }
