#version 3.7;
global_settings { assumed_gamma 1 }
#macro Str() "text" #end
#macro Vec() <1,2,3> #end
#macro Num() 42 #end
#macro Fn() function { x*2 } #end
#debug concat(Str(), str(Num(),0,0), str(Vec().y,0,0), str(vlength(Vec()),0,3), "\n")
#declare F = Fn()
#debug concat(str(F(4,0,0),0,0), "\n")
#macro Chain(A) A #end
#debug concat(Chain(Chain(Str())), str(Chain(Num()) + Chain(Num()),0,0), "\n")
#macro Cat(A,B) concat(A,B) #end
#debug Cat(Cat("a","b"),Cat("c","\n"))
#macro Two() 1, 2 #end
#debug concat(str(max(Two()),0,0), str(min(Two(), Two()),0,0), "\n")
