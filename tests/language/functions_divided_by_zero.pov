// Two numbers divided within a function: infinite where the divisor is 0.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare Up = function { 1/0 }
#declare Down = function(x) { -3/0 + x }
#declare Folded = function { 1/(2 - 2) }
#declare Named = function(x) { 1/x }
#debug concat(str(Up(0, 0, 0), 0, 2), " ", str(Down(5), 0, 2), "\n")
#debug concat(str(Folded(0, 0, 0), 0, 2), " ", str(Named(0), 0, 2), "\n")
