#version 3.7;
global_settings { assumed_gamma 1 }
#fopen F "target/made.inc" write
#write (F, "#declare Made = 5;\n#macro MM(A) (A*Made) #end\n#debug \"in made\\n\"\n")
#fclose F
#include "target/made.inc"
#debug concat(str(MM(3),0,0), "\n")
#include concat("target/ma", "de.inc")
