// Files have names of their own.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare G = 1; #include "scopes.inc" Show(G) Show(defined(FileLocal)) Show(FileGlobal) Show(FromMacro(2)) #include "scopes" Show(FileGlobal) #local Mine = 3; #include "scopes.inc" Show(Mine)

sphere { 0, 1 }
