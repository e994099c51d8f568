#version 3.7;
global_settings { assumed_gamma 1 }
#macro W(V)
#switch (V)
  #case (1) #debug "one "
  #case (2) #debug "two " #break
  #range (3, 5) #debug "three-five "
  #range (4, 6) #debug "four-six " #break
  #case (0.1+0.2) #debug "0.3 " #break
  #else #debug "else "
#end
#debug "\n"
#end
W(1) W(2) W(3) W(5) W(6) W(7) W(0.3) W(2.9999999999999) W(-1) W(5.0000000000001) W(1.0000000001)
#declare D = 0.5;
#while (D < 3)
  #switch (D)
    #range (0, 1) #debug concat("a", str(D,0,1), " ") #break
    #case (1.5) #debug "mid "
    #range (1.6, 3) #debug concat("c", str(D,0,1), " ")
  #end
  #declare D = D + 0.5;
#end
#debug "\n"
