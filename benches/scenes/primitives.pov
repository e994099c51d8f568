// One primitive, many times over: a block of copies, a floor that takes their shadows, a mirror behind them.
// Shape chooses which.
#version 3.7;
global_settings { assumed_gamma 1 }
#ifndef (Shape) #declare Shape = 1; #end

camera { location <1, 5, -14> look_at <0, 0.4, 0> angle 42 }
light_source { <-9, 16, -12> rgb 1 }
background { rgb <0.3, 0.4, 0.5> }
plane { y, -3.5 pigment { checker rgb 0.8, rgb 0.6 } }
plane { -z, -6 pigment { rgb 0.1 } finish { reflection 0.7 diffuse 0.2 } }

#macro Beads(N)
  #local R = seed(7); #local I = 0;
  #while (I < N) , <rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>*1.6, 0.1 + 0.2*rand(R) #local I = I + 1; #end
#end

#declare Thing =
#switch (Shape)
#case (1) // sphere
  sphere { 0, 0.9 }
#break
#case (2) // box
  box { <-0.7, -0.8, -0.6>, <0.8, 0.7, 0.5> }
#break
#case (3) // cylinder
  cylinder { -0.8*y, 0.8*y, 0.6 }
#break
#case (4) // cone
  cone { -0.8*y, 0.8, 0.8*y, 0.2 }
#break
#case (5) // torus
  torus { 0.65, 0.3 }
#break
#case (6) // disc
  disc { 0, <0.2, 1, -0.8>, 0.95, 0.3 }
#break
#case (7) // plane
  intersection { plane { y, 0.6 } plane { -y, 0.7 } plane { x + y, 0.6 } plane { -x, 0.7 } plane { z, 0.5 } plane { -z + y, 0.7 } }
#break
#case (8) // triangle
  triangle { <-0.9, -0.8, -0.2>, <0.9, -0.7, 0.4>, <0, 0.9, 0> }
#break
#case (9) // smooth_triangle
  smooth_triangle { <-0.9, -0.8, -0.2>, <-1, -1, -2>, <0.9, -0.7, 0.4>, <1, -1, -2>, <0, 0.9, 0>, <0, 1, -2> }
#break
#case (10) // polygon
  polygon { 11, <0, 0.9>, <0.2, 0.3>, <0.9, 0.3>, <0.35, -0.1>, <0.55, -0.8>, <0, -0.35>, <-0.55, -0.8>, <-0.35, -0.1>, <-0.9, 0.3>, <-0.2, 0.3>, <0, 0.9> }
#break
#case (11) // mesh
  mesh {
    #local N = 24; #local I = 0;
    #macro On(I, J) #local A = pi*I/N; #local B = 2*pi*J/N; 0.9*<sin(A)*cos(B), cos(A), sin(A)*sin(B)> #end
    #while (I < N) #local J = 0; #while (J < N)
      triangle { On(I, J), On(I, J + 1), On(I + 1, J) } triangle { On(I, J + 1), On(I + 1, J), On(I + 1, J + 1) }
    #local J = J + 1; #end #local I = I + 1; #end
  }
#break
#case (12) // quadric
  intersection { quadric { <1, -0.7, 1>, <0.2, 0, 0>, 0, -0.2 } box { -0.8, 0.8 } }
#break
#case (13) // cubic
  intersection { cubic { <1, 0.3, 0, 0, -0.4, 0, 0, 0, 0, -0.3, 0.5, 0, 0, 0, 0, 0.2, 0, 0, -0.6, 0> } box { -0.8, 0.8 } }
#break
#case (14) // quartic
  quartic { <1,0,0,0, 2,0,0,2,0, -0.82, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0, 0.62, 0,0,0,0, 1,0, -0.82, 0, 0.07> scale 1.1 }
#break
#case (15) // polynomial
  polynomial { 6, xyz(6,0,0): 1, xyz(0,6,0): 2, xyz(0,0,6): 1.5, xyz(1,1,0): -0.5, xyz(0,0,0): -0.2 }
#break
#case (16) // superellipsoid
  superellipsoid { <0.4, 1.6> scale 0.9 }
#break
#case (17) // blob
  blob {
    threshold 0.5
    #local R = seed(3); #local I = 0;
    #while (I < 24) sphere { <rand(R) - 0.5, rand(R) - 0.5, rand(R) - 0.5>*1.5, 0.45, 0.8 } #local I = I + 1; #end
    cylinder { <-0.8, 0, 0>, <0.8, 0.2, 0>, 0.3, 1 }
  }
#break
#case (18) // lathe
  lathe { bezier_spline 8, <0.1, -0.9>, <1.2, -0.7>, <0.3, -0.2>, <0.4, 0>, <0.4, 0>, <0.5, 0.2>, <1, 0.4>, <0.8, 0.9> }
#break
#case (19) // sor
  sor { 7, <0.3, -1.1>, <0.5, -0.9>, <0.75, -0.3>, <0.3, 0.1>, <0.5, 0.5>, <0.7, 0.9>, <0.8, 1.1> }
#break
#case (20) // prism
  prism { cubic_spline -0.5, 0.5, 9, <0.8, -0.6>, <-0.7, -0.7>, <-0.2, 0>, <-0.6, 0.7>, <0.7, 0.6>, <0.3, 0>, <0.8, -0.6>, <-0.7, -0.7>, <-0.2, 0> }
#break
#case (21) // conic_prism
  prism { bezier_spline conic_sweep 0.3, 1, 8, <0.9, 0>, <0.9, 1>, <-0.9, 1>, <-0.9, 0>, <-0.9, 0>, <-0.6, -1>, <0.6, -1>, <0.9, 0> translate -0.6*y scale 1.2 }
#break
#case (22) // sphere_sweep
  sphere_sweep { cubic_spline 7, <-0.9, -0.6, 0>, 0.1, <-0.8, 0.2, 0.2>, 0.2, <0, -0.5, -0.3>, 0.3, <0.2, 0.6, 0.3>, 0.15, <0.6, 0.3, 0>, 0.25, <0.8, -0.6, 0>, 0.1, <0.9, -0.9, 0>, 0.1 }
#break
#case (23) // linear_sweep
  sphere_sweep { linear_spline 12 Beads(12) }
#break
#case (24) // ovus
  ovus { 0.8, 0.5 translate -0.3*y }
#break
#case (25) // text
  text { internal 1 "Glint" 0.3, 0 translate <-1, -0.3, 0> scale <0.9, 1.4, 1> }
#break
#case (26) // bicubic_patch
  bicubic_patch {
    type 1 flatness 0.005 u_steps 4 v_steps 4
    <-0.9, -0.9, 0>, <-0.3, -0.9, -0.9>, <0.3, -0.9, 0.8>, <0.9, -0.9, 0>,
    <-0.9, -0.3, 0.6>, <-0.3, -0.3, 0>, <0.3, -0.3, 0>, <0.9, -0.2, -0.6>,
    <-0.9, 0.3, 0>, <-0.3, 0.3, 0.4>, <0.3, 0.3, 0.7>, <0.9, 0.3, 0>,
    <-0.9, 0.9, 0>, <-0.3, 0.9, -0.9>, <0.3, 0.9, 0>, <0.9, 0.9, 0.5>
  }
#break
#case (27) // height_field
  height_field { function 64, 64 { 0.5 + 0.3*sin(17*x)*cos(19*y) + 0.1*sin(57*x + 31*y) } smooth translate -0.5 scale <1.7, 0.9, 1.7> }
#break
#case (28) // isosurface
  isosurface {
    function { x*x + y*y + z*z - 0.6 + 0.15*sin(7*x)*sin(7*y)*sin(7*z) }
    contained_by { sphere { 0, 1 } } max_gradient 3.2 accuracy 0.001
  }
#break
#case (29) // parametric
  parametric {
    function { 0.7*cos(u)*cos(v) } function { 0.9*sin(v) } function { 0.7*sin(u)*cos(v) }
    <0, -1.4>, <6.2831853, 1.4>
    contained_by { box { -0.95, 0.95 } } max_gradient 1 accuracy 0.005 precompute 10, x, y, z
  }
#break
#case (30) // julia_fractal
  julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 30 scale 0.8 }
#break
#case (31) // difference
  difference { sphere { 0, 0.9 } box { <-0.3, -0.3, -1>, <1, 0.4, 1> } cylinder { -z, z, 0.3 } }
#break
#case (32) // merge
  merge { sphere { -0.3*x, 0.6 } box { <-0.2, -0.4, -0.4>, <0.9, 0.4, 0.4> } cylinder { -0.8*y, 0.8*y, 0.3 } }
#break
#end

#declare I = 0;
#while (I < 27)
  object {
    Thing
    pigment { rgb <0.55 + 0.35*cos(I), 0.55 + 0.35*cos(I + 2), 0.55 + 0.35*cos(I + 4)> }
    finish { specular 0.4 }
    rotate <40*I, 25*I, 0> + <10, 20, 30>
    translate <mod(I, 3) - 1, mod(floor(I/3), 3) - 1, floor(I/9) - 1>*2.2
  }
  #declare I = I + 1;
#end
