// Reading numbers out of strings.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(val("12")) Show(val("-1.5e2")) Show(val("  7")) Show(val("3abc")) Show(val("abc")) Show(val("")) Show(val("0x10")) Show(val(".5")) Show(val("+4")) Show(val("1e")) Show(val("1 2"))
Show(val(concat("1", "2"))*2) Show(val(str(pi, 0, 10))) Show(val(substr("x=42;", 3, 2)))

sphere { 0, 1 }
