// Names that stand before the scene.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "show.inc"

Show(image_width) Show(image_height) Show(frame_number) Show(initial_frame) Show(final_frame) Show(initial_clock) Show(final_clock) Show(clock_delta) Show(clock) Show(clock_on) ShowS(input_file_name) Show(image_width/image_height)
#declare image_width = 5; Show(image_width)

sphere { 0, 1 }
