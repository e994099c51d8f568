// A number taken out of a vector, where a vector is wanted: POV-Ray replaces the first component alone. It does so
// through signs and sums, not in parentheses, and not where the number stands first or is kept under a name.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare A = <0.1, 0.2, 0.3>;
#declare B = <0.4, 0.5>;
#declare C = rgb <0.1, 0.2, 0.3>;
#declare Row = array[1] { A }
#declare Path = spline { linear_spline 0, <1, 2, 3> 1, <3, 4, 5> }
#declare F = 2;
#macro Show(Name, V) #debug concat(Name, " ", vstr(3, V, " ", 0, 4), "\n") #end
Show("variable", vrotate(A.x, 0))
Show("literal", vrotate(<1, 2, 3>.y, 0))
Show("pair", vrotate(B.y, 0))
Show("color", vrotate(C.green, 0))
Show("element", vrotate(Row[0].z, 0))
Show("spline", vrotate(Path(0.5).y, 0))
Show("grey", vrotate(A.gray, 0))
Show("minus", vrotate(-A.y, 0))
Show("not", vrotate(!A.y, 0))
Show("times", vrotate(A.y*F, 0))
Show("divided", vrotate(A.z/2, 0))
Show("sum", vrotate(A.y + A.z*2, 0))
Show("difference", vrotate(A.y - 1, 0))
Show("number first", vrotate(F*A.y, 0))
Show("one plus", vrotate(1 + A.y, 0))
Show("parentheses", vrotate((A.y), 0))
Show("their member", vrotate((2*A).y, 0))
Show("function", vrotate(abs(A.y), 0))
Show("chosen", vrotate((1 ? A.y : 0), 0))
Show("times a vector", vrotate(A.y*<1, 1, 1>, 0))
#declare Kept = A.y;
Show("kept", vrotate(Kept, 0))
Show("cross", vcross(A.x, y))
#debug concat("length ", str(vlength(Path(0).x), 0, 4), " dot ", str(vdot(A.x, <1, 1, 1>), 0, 4), "\n")
#debug concat("text ", vstr(4, Path(0).z, " ", 0, 4), "\n")
#macro Box(Name, Thing) Show(Name, max_extent(Thing)) #end
#declare S = sphere { A.z, 1 }
Box("center", S)
#declare S = sphere { 0, 1 scale A.y }
Box("scale", S)
#declare S = sphere { 0, 1 translate A.z*2 }
Box("translate", S)
#declare S = box { 0, A.x + 1 }
Box("corner", S)
#declare P = pigment { rgb A.y }
#declare G = function { pigment { P } }
#declare Seen = G(0, 0, 0);
Show("color", <Seen.red, Seen.green, Seen.blue>)
#declare Number = str(A.y*2, 0, 3);
#debug concat("number ", Number, "\n")
