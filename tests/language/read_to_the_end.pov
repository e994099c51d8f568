#version 3.7;
global_settings { assumed_gamma 1 }
#fopen F "target/t2.txt" write
#write (F, "\"a\",\"b c\",\n1,2,\n")
#write (F, "3,<4,5,5>,<6,7,8,9>\n")
#fclose F
#fopen F "target/t2.txt" read
#declare N = 0;
#while (defined(F))
  #read (F, Z)
  #declare N = N + 1;
  #debug concat(str(N,0,0), "\n")
#end
