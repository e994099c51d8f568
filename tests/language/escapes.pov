// Escapes in strings.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

ShowS("quote \" backslash \\ tick \'") ShowS("tab\tend") ShowS("\u0041\u0062") Show(strlen("\\")) Show(strlen("\u00e9")) Show(asc("\n")) Show(asc("\t")) Show(asc("\a")) Show(asc("\b")) Show(asc("\f")) Show(asc("\r")) Show(asc("\v")) Show(asc("\u20ac"))
ShowS("/* no comment */ // neither") ShowS("#if (0)") ShowS("two
lines")

sphere { 0, 1 }
