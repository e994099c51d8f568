#version 3.7;
global_settings { assumed_gamma 1 }
#debug concat(str(2*-3,0,0), " ", str(1-1-1,0,0), " ", str(8/4/2,0,0), " ", str(--3,0,0), " ", str(+3,0,0), "\n")
#debug concat(str(1+2*3-4/2,0,0), " ", str((1+2)*3,0,0), " ", str((1<2=1),0,0), " ", str((!0&!0),0,0), " ", str(yes+on+true,0,0), "\n")
#debug concat(str(pi,0,15), " ", str(clock,0,3), " ", str(image_width,0,0), str(image_height,0,0), " ", str((now>7000),0,0), "\n")
#debug concat(str(frame_number,0,0), str(final_frame,0,0), str(initial_frame,0,0), str(final_clock,0,1), str(clock_on,0,0), str(clock_delta,0,1), "\n")
#debug concat(str(int(-2.5),0,0), str(floor(-2.5),0,0), str(ceil(-2.5),0,0), " ", str(mod(-7,3),0,1), " ", str(mod(7,-3),0,1), " ", str(div(-7,2),0,0), " ", str(mod(7.5,2),0,2), "\n")
