// #if, #elseif, #ifdef.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro Kind(N) #if (N < 0) ShowS("negative") #elseif (N = 0) ShowS("zero") #elseif (N < 10) ShowS("small") #else ShowS("large") #end #end
Kind(-1) Kind(0) Kind(5) Kind(50)
#ifdef (Nothing) ShowS("yes") #else ShowS("no") #end #declare Something = 0; #ifdef (Something) ShowS("yes") #else ShowS("no") #end #ifndef (Something) ShowS("yes") #else ShowS("no") #end
Show(defined(Something)) Show(defined(Nothing)) Show(defined(x)) Show(defined(Kind)) Show(!defined(Nothing)) #if (defined(Something) & !defined(Nothing)) ShowS("both") #end
#if (0) #if (1) ShowS("a") #else ShowS("b") #end #else #if (0) ShowS("c") #elseif (1) ShowS("d") #end #end
#if (0) { ( < [ #declare #else ShowS("unbalanced text is skipped") #end

sphere { 0, 1 }
