// A trefoil knot of balls and cones, made by functions of one angle; an old-fashioned scene without #version.

camera { location <0, 1.2, -8.2> look_at <0, 0, 0> angle 42 }
light_source { <-6, 9, -8> color rgb <1, 0.95, 0.85> }
light_source { <8, 2, -4> color rgb <0.25, 0.30, 0.45> }
background { color rgb <0.10, 0.11, 0.15> }

#declare Knot_X = function (a) { (sin(a) + 2*sin(2*a))*0.78 }
#declare Knot_Y = function (a) { (cos(a) - 2*cos(2*a))*0.78 }
#declare Knot_Z = function (a) { -sin(3*a)*0.75 }

union {
  #declare Turn = 0;
  #while (Turn < 120)
    #declare A = 2*pi*Turn/120;
    #declare B = 2*pi*(Turn + 1)/120;
    #declare Here = <Knot_X(A), Knot_Y(A), Knot_Z(A)>;
    #declare Next = <Knot_X(B), Knot_Y(B), Knot_Z(B)>;
    #declare Paint = color rgb <0.5 + 0.45*sin(A), 0.42 + 0.3*sin(A + 2.1), 0.5 + 0.45*sin(A + 4.2)>;
    sphere { Here, 0.36 pigment { color Paint } }
    cylinder { Here, Next, 0.36 pigment { color Paint } }
    #declare Turn = Turn + 1;
  #end
  finish { ambient 0.12 diffuse 0.6 phong 0.8 phong_size 60 reflection 0.12 }
  rotate <25, -20, 0>
}
plane { y, -3 pigment { checker color rgb <0.30, 0.30, 0.34> color rgb <0.18, 0.18, 0.22> } finish { reflection 0.15 } }
