// Strings where they end: before the first character, at the character 0, at the longest number.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

ShowS(substr("abc", 0, 1)) ShowS(substr("abc", 0, 0)) ShowS(substr("abc", 1, 0)) ShowS(substr("abc", 4, 0)) ShowS(substr("abc", 0, 4))
ShowS(substr("", 1, 0)) ShowS(substr("", 0, 0)) ShowS(substr("abc", 0.9, 1.9)) ShowS(substr("abc", 1.9, 1.9))
ShowS(chr(0)) Show(strlen(chr(0))) ShowS(concat("a", chr(0), "b")) Show(strlen(concat("a", chr(0), "b"))) ShowS(chr(0.5)) ShowS(chr(65.9))
ShowS(str(5, 300, 3)) ShowS(str(5, -255, 3)) ShowS(str(5, 0, 300)) ShowS(str(1/3, 0, 300)) ShowS(str(1e300, 20, 3)) ShowS(str(-1e300, 0, 3))
ShowS(str(-1e300, -20, 3)) ShowS(str(1e300, -20, 0)) ShowS(str(1e300, 0, -1)) ShowS(str(5.25, 0, -3)) ShowS(str(1.23456789e300, 0, 5))
Show(strlen(str(5, 254, 3))) Show(strlen(str(pow(2, 900), 0, 248))) Show(strlen(str(pow(2, 900), 0, 249))) Show(strlen(str(5.5, 254, 254)))
Show(strlen(str(1e-7, 0, 254))) ShowS(str(5.5, 20, 254)) ShowS(str(-5.5, -20, 254)) ShowS(str(0, 20, 254)) ShowS(str(1.5e300, 0, 1))
Show(strlen(vstr(3, <1, 2, 3>, ",", 300, 3)))

sphere { 0, 1 }
