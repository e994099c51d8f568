// Names and the letter case.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#declare a = 1; #declare A = 2; #declare _b1 = 3; #declare Sphere = 4; #declare X = 5; #declare If = 6; #declare COLOR = 7; #declare this_is_a_long_name_with_many_letters_in_it_123 = 8;
Show(a) Show(A) Show(_b1) Show(Sphere) Show(X) Show(If) Show(COLOR) Show(this_is_a_long_name_with_many_letters_in_it_123)
#declare A = x; ShowV(A) #declare A = "s"; ShowS(A) #declare A = array[1]{3} Show(A[0]) #declare A = 9; Show(A)

sphere { 0, 1 }
