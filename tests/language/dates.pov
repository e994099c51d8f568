// Dates from days since 2000.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

ShowS(datetime(0)) ShowS(datetime(5000.5, "%Y/%j %H")) ShowS(datetime(1, "%d.%m.%Y")) ShowS(datetime(-1)) ShowS(datetime(0.999, "%H:%M:%S")) ShowS(datetime(366, "%y %b %a")) ShowS(datetime(59, "%B %d %A")) ShowS(datetime(10000, "%%"))
#if (now > 5000) ShowS("later than 2013") #end

sphere { 0, 1 }
