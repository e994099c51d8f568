// What #local names in a macro is gone behind it, even where the right side looks on behind the macro's end.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro Left() #ifdef (T) ShowS("left") #else ShowS("gone") #end #end
#macro A() #local T = texture { pigment { rgb 1 } } #end A() Left()
#macro B() #local T = array[2]{1, 2} #end B() Left()
#macro C() #local T = sphere { 0, 1 } #end C() Left()
#macro D() #local T = "a" #end D() Left()
#macro E() #local T = spline { 0, x, 1, y } #end E() Left()
#macro F() #local T = 5; #end F() Left()
#macro G() #local T = texture { pigment { rgb 1 } } Left() #end G() Left()
#macro H() A() Left() #end H() Left()
#macro K() #declare Late = 1 #end K() + 2; Show(Late)
#version 3.1;
#macro I() #local T = 5 #end I() Left()
#macro J() #local T = <1, 2, 3> #end J() Left()

sphere { 0, 1 }
