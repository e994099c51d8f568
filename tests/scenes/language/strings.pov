// Strings: built, compared, cut, and turned into numbers.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Word = concat("ab", strupr("c"), str(3.14159, 0, 2));
#declare I = 1;
#while (I <= strlen(Word))
  #local Letter = substr(Word, I, 1);
  #if (strcmp(Letter, "a") < 0)
    box { -0.15, 0.15 translate <-2 + I*0.55, asc(Letter)/100 - 0.7, 0> pigment { rgb <0.8, 0.6, 0.2> } }
  #else
    sphere { <-2 + I*0.55, asc(Letter)/100 - 0.7, 0>, 0.2 pigment { rgb <0.2, 0.6, 0.8> } }
  #end
  #declare I = I + 1;
#end
cylinder { <-2, -1, 0.6>, <-2 + val("4.0"), -1, 0.6>, 0.1 pigment { rgb 0.5 } }
