// The number of the language.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(version) #version 3.5; Show(version) #declare V = version; #version 3.7; Show(version) Show(V) #if (0) #version 3.1; #end Show(version) #version V; Show(version) #version 3.1; #declare NoSemicolon = 5 Show(NoSemicolon) #version 3.7;

sphere { 0, 1 }
