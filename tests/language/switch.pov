// Clauses fall through.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

#macro Try(V) #switch (V) #case (1) ShowS("one") #case (2) ShowS("two") #break #case (3) ShowS("three") #break #else ShowS("other") #end #end
Try(1) Try(2) Try(3) Try(4) Try(1+1e-11) Try(-1)
#macro Band(V) #switch (V) #range (0, 1) ShowS("low") #break #range (1, 2) ShowS("high") #break #case (5) ShowS("five") #range (10, 20) ShowS("ten") #end #end
Band(0) Band(1) Band(1.5) Band(2.0000000001) Band(5) Band(15) Band(30) Band(-1e-12)

#switch (2) #case (2) #switch (3) #case (3) ShowS("inner") #break #end ShowS("outer") #break #case (4) ShowS("no") #end
#switch (7) #case (1) ShowS("no") #end ShowS("after")

sphere { 0, 1 }
