// Comments nest, strings hide them.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(1) // Show(2)
/* Show(3) /* nested */ Show(4) */ Show(5) /* // */ Show(6)
Show(7 /* inside */ + 1) // "quote
#if (0) /* #end */ // #end
#else Show(9) #end
#macro M(/* nothing */) 10 /* ten */ #end Show(M())
ShowS("/* text */") /**/ Show(11) /***/ Show(12) //*/ Show(13)
Show(14)

sphere { 0, 1 }
