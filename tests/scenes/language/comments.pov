// Comments nest; strings hide them; #if (0) hides anything balanced.
#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
/* outside /* inside */ still outside */
#declare Text = "/* not a comment */ // nor this";
#if (0)
  nothing here is read @ all, but #if (1) and #end are matched
#end
sphere { -x, strlen(Text)/60 pigment { rgb <0.9, 0.6, 0.3> } } // the end
sphere{x,.5pigment{rgb<.3,.6,.9>}}
