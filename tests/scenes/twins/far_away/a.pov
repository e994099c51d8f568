// At the origin.
#version 3.7;
global_settings { assumed_gamma 1 }
#declare O = <0, 0, 0>;
camera { location <0, 1.5, -5> + O look_at O angle 46 }
light_source { <4, 6, -5> + O rgb 1 }
sphere { <-0.9, 0, 0> + O, 0.8 pigment { rgb <0.8, 0.4, 0.3> } finish { reflection 0.2 phong 0.5 } }
box { <-0.5, -0.6, -0.5>, <0.5, 0.6, 0.5> rotate 30*y translate <0.9, 0, 0> + O pigment { rgb <0.3, 0.5, 0.8> } }
torus { 1.7, 0.1 translate -0.8*y + O pigment { rgb <0.8, 0.7, 0.3> } }
