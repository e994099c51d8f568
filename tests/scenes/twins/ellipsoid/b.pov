// The same by one matrix.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 1.5, -5> look_at 0 angle 46 }
light_source { <4, 6, -5> rgb 1 }
plane { y, -1 pigment { checker rgb 0.8, rgb 0.4 } }
#declare Cx = vrotate(0.5*x, <10, 20, 30>);
#declare Cy = vrotate(1.1*y, <10, 20, 30>);
#declare Cz = vrotate(0.8*z, <10, 20, 30>);
sphere { 0, 1 matrix <Cx.x, Cx.y, Cx.z, Cy.x, Cy.y, Cy.z, Cz.x, Cz.y, Cz.z, 0.2, 0, 0.1> pigment { rgb <0.8, 0.6, 0.3> } finish { phong 0.5 } }
