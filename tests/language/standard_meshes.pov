// Meshes of meshmaker.inc: their boxes, where rays meet them and the normals there.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "meshmaker.inc"

#macro Show(Name, Vec)
  #debug concat("\n> ", Name, " ", vstr(3, Vec + 1e-8*<1, 1, 1>, " ", 0, 5), "\n")
#end
#macro Seen(Name, Mesh, From, Towards, Normals)
  #local Surface_Normal = <0, 0, 0>;
  #local Object = object { Mesh }
  Show(concat(Name, " from"), min_extent(Object))
  Show(concat(Name, " to"), max_extent(Object))
  #local Hit = trace(Object, From, Towards, Surface_Normal);
  Show(concat(Name, " hit"), Hit)
  #if (Normals) Show(concat(Name, " normal"), Surface_Normal) #end
#end

#declare Through = array[5] { <0,0,0>, <1,1,1>, <2,0,2>, <4,1,5>, <7,3,1> }
#macro Splines(Type)
  #local Curve = BuildSpline(Through, Type)
  #for (Index, 0, 4) Show(concat("spline ", Type), <0,0,0> + Curve(Index/4)) #end
#end
Splines("c") Splines("L") Splines("q") Splines("x")

#declare Profile = spline { cubic_spline -0.25, <1,-1,0> 0, <1,0,0> 0.3, <2,1,0> 0.6, <1.5,2,0.2> 1, <1,3,0.5> 1.3, <0.5,4,0> }
Seen("lathe", Lathe(Profile, 5, 360, 8, ""), <3, 1.1, -4>, <-0.6, 0, 0.8>, true)
Seen("lathe part", Lathe(Profile, 3, -90, 2, ""), <4, 2, 4>, <-1, -0.1, -0.9>, true)

#declare Base = spline { natural_spline -0.25, <0,0,1> 0, <1,0,0> 0.25, <0,1,-1.2> 0.5, <-1,0,0.3> 0.75, <0,.6,1> 1, <1,0,0> 1.25, <0,0,-1> }
#declare Side = spline { cubic_spline -0.25, <1,-1,0> 0, <2,0.5,0> 0.5, <3,1,1> 1, <1,3,0.3> 1.3, <0.5,4,0> }
Seen("prism", Prism(Base, 6, 1.5, 3, ""), <0.2, 1, -4>, z, true)
Seen("prism1", Prism1(Base, 6, Side, 4, ""), <0.2, 2, -4>, z, true)

#declare S1 = spline { linear_spline 0, <0,0,0> 0.5, <0.5,0.3,0.1> 1, <1,0,0> }
#declare S2 = spline { natural_spline 0, <1,0,0> 0.5, <1,0.3,0.5> 1, <1,0.2,1> }
#declare S3 = spline { natural_spline 0, <1,0.2,1> 0.5, <0.6,0.3,1.1> 1, <0,0,1> }
#declare S4 = spline { linear_spline 0, <0,0,1> 0.5, <0,-0.3,0.5> 1, <0,0,0> }
Seen("coons", Coons(S1, S2, S3, S4, 6, 4, ""), <0.33, 3, 0.77>, -y, true)

#declare Fx = function(u, v) { u + 0.1*v*v }
#declare Fy = function(u, v) { u*v*v*v }
#declare Fz = function(u, v) { v - 0.2*u*u*u }
Seen("parametric", Parametric(Fx, Fy, Fz, <0, -1>, <2, 1.5>, 5, 4, ""), <1.1, 9, 0.3>, -y, true)
#declare __Fx = function(u, v) { u }
#declare __Fy = function(u, v) { sin(u*v) }
#declare __Fz = function(u, v) { v }
Seen("paramcalc", Paramcalc(<FromU(-1), FromV(-1)>, <ToU(1), ToV(2)>, 6, 6, ""), <0.21, 3, 0.33>, -y, true)
#declare Height = function(u, v) { sin(u)*v + 0.3*u*u }
Seen("two", TwoVarSurf(Height, <-1, 1.5>, <0, 2>, 6, 5, ""), <0.31, 0.77, -5>, z, false)

#declare Track = spline { cubic_spline -0.3, <0,0,-1> 0, <0,0,0> 0.4, <3,5,10> 1, <10,10,20> 1.2, <20,10,30> }
#declare Section = spline { cubic_spline -0.25, <0,1,0> 0, <1,0,0> 0.25, <0,-1.2,0> 0.5, <-1,0.3,0> 0.75, <0,1,0> 1, <1,0,0> 1.25, <0,-1,0> }
#declare Wide = spline { linear_spline 0, <1,1,1> 0.5, <0.5,0.7,0.9> 1, <1.2,1.3,1.4> }
#declare Width = spline { cubic_spline -1, 0 0, 0.2 0.8, 1 1, 1 2, 1.5 }
Seen("sweep1", SweepSpline1(Track, Section, Wide, 8, 6, ""), <3, 15, 10>, -y, false)
Seen("sweep2", SweepSpline2(Track, Section, Wide, 8, 6, ""), <3, 15, 10>, -y, false)
Seen("sweep of a number", SweepSpline1(Track, Section, Width, 5, 4, ""), <3.1, 15, 10>, -y, false)

#declare A1 = spline { cubic_spline -0.5, <1,-1,0> 0, <1,0,0> 0.5, <2,1,0> 1, <1,2,0> 1.5, <1,3,0> }
#declare A2 = spline { cubic_spline -0.5, <0,-1,1> 0, <0,0,1> 0.5, <0,1,2> 1, <0,3,1> 1.5, <0,4,1> }
#declare A3 = spline { cubic_spline -0.5, <-1,-1,0> 0, <-1,0,0> 0.5, <-2,1,0> 1, <-1,3,0> 1.5, <-2,3,0> }
#declare Curves = array[7] { spline { A3 }, spline { A1 }, spline { A2 }, spline { A3 }, spline { A1 }, spline { A2 }, spline { A3 } }
Seen("msm", MSM(Curves, 4, "c", 6, ""), <0.6, 1.3, -5>, z, true)
Seen("msm linear", MSM(Curves, 4, "l", 7, ""), <0.6, 1.3, -5>, z, true)

#debug concat("\n> ", str(LInterpolate(1.5, 2, 4), 0, 3), " ", str(RangeMM(7, 0, 2, 10, 20), 0, 3), "\n")
Show("between", LInterpolate(0.25, <0,0,0>, <1,2,3>))
#debug concat("\n> limits ", str(FromU(1), 0, 12), " ", str(ToV(1), 0, 12), "\n")
#debug concat("\n> files ", str(CheckFileName(""), 0, 0), " ", str(CheckFileName("nowhere.inc"), 0, 0), "\n")
#debug concat("\n> files ", str(CheckFileName("no.obj"), 0, 0), " ", str(CheckFileName("no.pcm"), 0, 0), "\n")
#debug concat("\n> files ", str(CheckFileName("no.arr"), 0, 0), " ", str(CheckFileName("show.inc"), 0, 0), "\n")
