// Every finite primitive, with mirror and glass. K multiplies all lengths by 10^K: with `scale` on each object,
// or, with Deep = 1, in the numbers themselves. Away moves everything along x.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 8 }

#ifndef (K) #declare K = 0; #end
#ifndef (Deep) #declare Deep = 0; #end
#ifndef (Away) #declare Away = 0; #end
#declare S = pow(10, K);
// The unit of length in the objects' own numbers, and what they are scaled by afterwards.
#if (Deep) #declare U = S; #declare W = 1; #else #declare U = 1; #declare W = S; #end
#declare From = Away*x;

camera {
  right 4/3*x
  angle 54
  location U*W*<0, 1.5, -16> look_at U*W*<0, 0.4, 0>
  translate From
}
light_source { U*W*<-9, 14, -16> + From, rgb 1.6 fade_distance U*W*20 fade_power 2 }
background { rgb <0.2, 0.25, 0.3> }

#default { finish { ambient 0.15 diffuse 0.8 specular 0.3 roughness 0.05 } }

#declare Count = 0;
#macro Put(Thing)
  object {
    Thing
    pigment { rgb <0.55 + 0.35*cos(Count), 0.55 + 0.35*cos(Count + 2), 0.55 + 0.35*cos(Count + 4)> }
    rotate <-25, 35, 10>
    translate U*2.1*<mod(Count, 7) - 3, floor(Count/7) - 2, 0>
    scale W
    translate From
  }
  #declare Count = Count + 1;
#end

// Row by row from below.
Put(sphere { 0, U*0.8 })
Put(box { -U*<0.6, 0.5, 0.7>, U*<0.5, 0.6, 0.4> })
Put(cylinder { -U*0.7*y, U*0.6*y, U*0.5 })
Put(cone { -U*0.7*y, U*0.7, U*0.6*y, U*0.2 })
Put(torus { U*0.6, U*0.25 })
Put(disc { 0, y - z, U*0.8, U*0.3 })
Put(superellipsoid { <0.4, 1.6> scale U*0.7 })

Put(triangle { U*<-0.8, -0.6, 0>, U*<0.8, -0.5, 0>, U*<0.1, 0.8, 0> })
Put(smooth_triangle {
  U*<-0.8, -0.6, 0>, <-0.4, -0.2, -1>, U*<0.8, -0.5, 0>, <0.5, -0.1, -1>, U*<0.1, 0.8, 0>, <0, 0.5, -1>
})
Put(polygon { 5, U*<-0.7, -0.7>, U*<0.8, -0.6>, U*<0, 0>, U*<0.6, 0.8>, U*<-0.7, -0.7> })
Put(mesh {
  triangle { U*<-0.7, -0.5, -0.6>, U*<0.7, -0.6, -0.4>, U*<0, 0.8, 0> }
  triangle { U*<-0.7, -0.5, -0.6>, U*<0, -0.6, 0.8>, U*<0, 0.8, 0> }
  triangle { U*<0.7, -0.6, -0.4>, U*<0, -0.6, 0.8>, U*<0, 0.8, 0> }
  triangle { U*<0.7, -0.6, -0.4>, U*<0, -0.6, 0.8>, U*<-0.7, -0.5, -0.6> }
})
Put(mesh2 {
  vertex_vectors { 4, U*<-0.8, -0.7, 0>, U*<0.7, -0.8, 0.2>, U*<-0.7, 0.7, 0.1>, U*<0.8, 0.7, -0.2> }
  normal_vectors { 4, <-0.5, -0.5, -1>, <0.5, -0.5, -1>, <-0.5, 0.5, -1>, <0.5, 0.5, -1> }
  face_indices { 2, <0, 1, 2>, <1, 3, 2> }
})
Put(bicubic_patch {
  type 1 flatness 0 u_steps 3 v_steps 3
  <-0.8, -0.8, 0>*U, <-0.3, -0.7, -0.9>*U, <0.3, -0.8, 0.8>*U, <0.8, -0.8, 0>*U,
  <-0.8, -0.3, 0.6>*U, <-0.3, -0.3, 0>*U, <0.3, -0.3, 0>*U, <0.8, -0.2, -0.6>*U,
  <-0.8, 0.3, 0>*U, <-0.3, 0.3, 0.4>*U, <0.3, 0.3, 0.7>*U, <0.8, 0.3, 0>*U,
  <-0.8, 0.8, 0>*U, <-0.3, 0.8, -0.9>*U, <0.3, 0.8, 0>*U, <0.8, 0.8, 0.5>*U
})
// The font comes with POV-Ray.
#if (file_exists("timrom.ttf"))
  Put(text { internal 1 "Glint" 0.3, 0 translate <-1, -0.3, 0> scale U*0.75 })
#else
  Put(box { -U*<0.7, 0.2, 0.1>, U*<0.7, 0.2, 0.1> })
#end

Put(quadric { <2, 3, 4>/(U*U), <0.5, 0, 0.3>/(U*U), <0.2, 0, 0>/U, -1 })
Put(intersection {
  cubic { <1/(U*U*U), 0,0,0, 0,0,0,0,0, -0.3/U, 0,0,0,0, 0,0,0,0, -1/U, 0> }
  box { -U*0.7, U*0.7 }
})
Put(quartic { <1,0,0,0, 2,0,0,2,0, -0.82*U*U, 0,0,0,0,0,0,0,0,0,0, 1,0,0,2,0, 0.62*U*U, 0,0,0,0, 1,0, -0.82*U*U, 0, 0.07*U*U*U*U> })
Put(polynomial { 6, xyz(6,0,0): 1/pow(U,6), xyz(0,6,0): 2/pow(U,6), xyz(0,0,6): 1.5/pow(U,6), xyz(1,1,0): -0.5/(U*U), xyz(0,0,0): -0.2 })
Put(blob {
  threshold 0.5
  sphere { U*<-0.4, -0.3, 0>, U*0.7, 1 } sphere { U*<0.4, -0.2, 0>, U*0.7, 1 } sphere { U*<0, 0.3, -0.2>, U*0.6, 1.2 }
  cylinder { U*<-0.5, 0.5, 0>, U*<0.5, 0.6, 0.1>, U*0.4, 0.9 }
})
Put(lathe { bezier_spline 4, U*<0.1, -0.8>, U*<1.2, -0.6>, U*<0.2, 0.2>, U*<0.7, 0.7> })
Put(sor { 6, U*<0.3, -0.9>, U*<0.5, -0.7>, U*<0.75, -0.1>, U*<0.3, 0.3>, U*<0.5, 0.7>, U*<0.6, 0.9> })

Put(prism { cubic_spline -U*0.4, U*0.4, 7, U*<0.8, -0.6>, U*<-0.7, -0.7>, U*<-0.6, 0.7>, U*<0.7, 0.6>, U*<0.8, -0.6>, U*<-0.7, -0.7>, U*<-0.6, 0.7> })
Put(prism { linear_spline conic_sweep 0.2, 1, 5, <0.8, -0.6>, <-0.7, -0.7>, <-0.6, 0.7>, <0.7, 0.6>, <0.8, -0.6> translate -0.6*y scale U })
Put(sphere_sweep { cubic_spline 5, U*<-0.9, -0.6, 0>, U*0.1, U*<-0.6, 0.2, 0.2>, U*0.2, U*<0, -0.5, -0.3>, U*0.35, U*<0.5, 0.5, 0>, U*0.2, U*<0.9, 0.8, 0>, U*0.1 })
Put(ovus { U*0.7, U*0.4 })
Put(isosurface {
  function { x*x + y*y + z*z - U*U*0.5 + U*U*0.1*sin(6*x/U)*sin(7*y/U) }
  contained_by { box { -U*0.9, U*0.9 } } max_gradient U*4 accuracy U*1e-4
})
Put(parametric {
  function { U*0.6*cos(u/U)*cos(v/U) } function { U*0.7*sin(v/U) } function { U*0.6*sin(u/U)*cos(v/U) }
  U*<0, -1.2>, U*<6.2831853, 1.2>
  contained_by { box { -U*0.8, U*0.8 } } max_gradient 1 accuracy U*1e-3
})
Put(julia_fractal { <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 6 precision 100 scale U*0.7 })

Put(height_field { function 16, 16 { 0.5 + 0.4*sin(7*x)*cos(9*y) } smooth translate -0.5 scale U*<1.6, 0.8, 1.6> })
Put(difference { sphere { 0, U*0.8 } box { U*<-0.2, -0.3, -1>, U*<1, 0.4, 1> } })
Put(merge { box { -U*0.5, U*0.5 } cylinder { -U*0.8*x, U*0.8*x, U*0.3 } })
Put(intersection { cylinder { -U*y, U*y, U*0.6 } cylinder { -U*x, U*x, U*0.6 } })

// A mirror, glass that colours with the way through it, and a wall behind.
object { sphere { U*<4.3, 4.2, -2>, U*1.2 } pigment { rgb 0.1 } finish { reflection 0.8 ambient 0 diffuse 0.2 } scale W translate From }
object {
  box { -U*<1.6, 0.9, 0.5>, U*<1.6, 0.9, 0.5> }
  pigment { rgbt <0.95, 1, 0.95, 0.9> }
  finish { ambient 0 diffuse 0.1 reflection { 0.02, 1 fresnel } conserve_energy }
  interior { ior 1.4 fade_distance U*W*1.5 fade_power 1 fade_color <0.3, 0.7, 0.4> }
  rotate <10, 30, 5> translate U*<1.5, -1, -4> scale W translate From
}
object { box { U*<-12, -9, 3>, U*<13, 9, 3.5> } pigment { checker rgb 0.9, rgb <0.6, 0.6, 0.7> scale U*1.3 } scale W translate From }
