// Making strings.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

ShowS(concat("a", "b")) ShowS(concat("only")) ShowS(concat("", "x", "")) ShowS(strupr("aBc1z")) ShowS(strlwr("AbC1Z")) ShowS(substr("abcdef", 2, 3)) ShowS(substr("abc", 1, 3))
ShowS(chr(65)) ShowS(concat(chr(72), chr(105))) Show(asc("A")) Show(asc("")) Show(asc("zebra")) Show(strlen("")) Show(strlen("hello")) Show(strlen(concat("a\"b", "\\")))
#declare S = "text"; #declare T = S; #declare S = concat(S, "+"); ShowS(S) ShowS(T) ShowS(concat(S, T, str(1, 0, 0)))
#declare L = array[2]{"one", "two"} ShowS(L[1]) ShowS(concat(L[0], L[1])) Show(strlen(L[0]))

sphere { 0, 1 }
