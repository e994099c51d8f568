// Things in front of the camera of screen.inc: where their boxes are.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "screen.inc"
#macro Show(N, V) #debug concat(N, " ", vstr(3, V, ",", 0, 4), "\n") #end
#macro State()
  Show("place", CamL) Show("ahead", CamD) Show("right", CamR) Show("up", CamU)
  #debug concat(str(Camera_Zoom, 0, 5), " ", str(Camera_Aspect_Ratio, 0, 5), "\n")
#end
#macro Placed(O) #local It = object { O } Show("from", min_extent(It)) Show("to", max_extent(It)) #end
#declare Thing = box { <-0.1, -0.2, -0.3>, <0.4, 0.5, 0.6> }
State()
Placed(Screen_Object(Thing, <0.4, 0.8>, 0, false, 1))
Placed(Screen_Object(Thing, <0.4, 0.8>, 0, true, 1))
Placed(Screen_Object(Thing, <1, 0>, <0.1, 0.2>, true, 0.1))
Placed(Screen_Object(Thing, <0.02, 0.97>, 0.05, true, 1))
Placed(Screen_Object(box { -5, 5 }, <0.7, 0.9>, 0.1, true, 1))
Set_Camera(<1, 2, 3>, <5, 3, 2>, 50) Set_Camera_Sky(<0, 1, 0.3>) Set_Camera_Aspect(4, 2)
State()
Placed(Screen_Object(Thing, <0.3, 0.6>, 0.02, true, 0.5))
Placed(Screen_Plane(texture { pigment { rgb 1 } }, 0.1, <0.2, 0.1>, <0.8, 0.9>))
Set_Camera_Angle(90) State() Set_Camera_Zoom(3) State()
Set_Camera_Location(<0, 5, -5>) Set_Camera_Look_At(<0, 0, 1>) Set_Camera_Aspect_Ratio(1.5)
Placed(Screen_Object(Thing, <0.5, 0.5>, 0, true, 1))
Reset_Camera() State()
