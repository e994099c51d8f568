// A second semicolon behind a number, vector or colour; the macro's own and the caller's may be the two.
#version 3.7;
global_settings { assumed_gamma 1 }
#macro Show(Name, Value) #debug concat(Name, " ", str(Value, 0, 3), "\n") #end
#declare A = 3;; Show("number", A)
#declare V = <1, 2>;; Show("vector", V.y)
#declare C = rgb 2;; Show("color", C.red)
#declare Row = array[2];
#declare Row[0] = 5;; Show("element", Row[0])
#macro Next(X) X + 1; #end
#declare B = Next(3); Show("of a macro", B)
#macro Twice(X) Next(2*X) #end
#local B = Twice(3); Show("of its macro", B)
#macro Set(Name, To) #declare Name = To; #end
Set(A, 7); Show("set", A)
#declare Sum = 0;
#macro Add(X) #local Y = X*X; #declare Sum = Sum + Y; #end
#for (I, 1, 4) Add(I); Add(10*I); #end
Show("sum", Sum)
#declare I = 0;
#while (I < 9) #declare I = I + 2;; #end
Show("loop", I)
union {
  #local P = Next(1); sphere { P, 1 }
  #local P = Next(2); sphere { P, 1 }
}
