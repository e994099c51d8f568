#version 3.7;
global_settings { assumed_gamma 1 }
#switch (2)
  #case (1)
    #switch (9) #case (9) #debug "no" #end
  #break
  #case (2)
    #switch (3) #range (0,9) #debug "in " #break #else #debug "bad" #end
    #debug "after "
    #if (1) #break #end
    #debug "unreached"
  #else #debug "bad"
#end
#debug "\n"
#switch (<1,0,0>.x) #case (1) #debug "vec\n" #end
#switch (7) #case (1) #debug "a" #range (2,3) #debug "b" #end
#debug "none\n"
