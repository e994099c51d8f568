#version 3.7;
global_settings { assumed_gamma 1 }
#fopen F "target/t3.txt" write
#write (F, 1, ",", 2, ",", 3)
#fclose F
#fopen F "target/t3.txt" append
#write (F, ",", 4, ",", 5, "\n")
#fclose F
#fopen F "target/t3.txt" read
#declare S = 0;
#while (defined(F)) #read (F, Z) #declare S = S + Z; #debug concat(str(S,0,0), " ") #end
#debug "\n"
