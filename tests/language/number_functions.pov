#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat(str(exp(710)/exp(709),0,3), " ", str(atan2(0,-1),0,6), "\n")
#debug concat(str(bitwise_and(12,10),0,0), str(bitwise_or(12,10),0,0), str(bitwise_xor(12,10),0,0), " ", str(bitwise_or(12,10,1),0,0), "\n")
#debug concat(str(select(-1,1,2,3),0,0), str(select(0,1,2,3),0,0), str(select(0,1,2),0,0), "\n")
#debug concat(str(min(1,2,<3,4,5>.y),0,0), str(max(-1,-2),0,0), str(abs(-3),0,0), str(sqrt(2),0,8), str(degrees(1),0,8), "\n")
