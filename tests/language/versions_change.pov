#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat(str(version,0,2),"\n")
#version 3.1;
#debug concat(str(version,0,2),"\n")
#switch (version) #case (3.1) #debug "3.1\n" #break #else #debug "other\n" #end
#version unofficial 3.5;
#debug concat(str(version,0,3),"\n")
#version 3.7;
#if (version >= 3.5) #debug "new\n" #end
#declare V = version;
#version V;
#debug concat(str(version,0,4),"\n")
#version 3.6+0.05;
#debug concat(str(version,0,4),"\n")
