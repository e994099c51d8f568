// strcmp gives the difference of codes; operators compare.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(strcmp("a", "c")) Show(strcmp("c", "a")) Show(strcmp("abc", "ab")) Show(strcmp("ab", "abc")) Show(strcmp("", "")) Show(strcmp("", "a")) Show(strcmp("A", "a")) Show(strcmp("10", "9"))
#if (strcmp("x", "x") = 0) ShowS("same") #end #if ("abc" < "abd") ShowS("less") #end #if ("Z" < "a") ShowS("capitals first") #end
Show(("a" = "a")+("a" <= "a")+("a" >= "a")) Show(("" < "a")) Show((concat("a", "b") = "ab"))

sphere { 0, 1 }
