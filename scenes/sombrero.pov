// mesh2 with vertices, normals and indices written by loops: a drop's splash, smooth though made of flat pieces.

#version 3.7;
global_settings { assumed_gamma 1 }

camera { location <0, 3.6, -6.5> look_at <0, -0.15, 0> angle 40 }
light_source { <-6, 8, -2> rgb <1.0, 0.95, 0.88> }
light_source { <7, 5, -7> rgb <0.22, 0.28, 0.4> }
background { rgb <0.07, 0.08, 0.11> }

#declare Wave = function (r) { 0.9*cos(4.2*r)*exp(-0.3*r*r) }
#declare Slope = function (r) { (Wave(r + 1e-4) - Wave(r - 1e-4))/2e-4 }
#declare Rings = 36;
#declare Sides = 72;
mesh2 {
  vertex_vectors {
    Rings*Sides,
    #for (I, 0, Rings - 1) #for (J, 0, Sides - 1)
      #local R = 0.01 + 3*I/(Rings - 1);
      <R*cos(2*pi*J/Sides), Wave(R), R*sin(2*pi*J/Sides)>,
    #end #end
  }
  normal_vectors {
    Rings*Sides,
    #for (I, 0, Rings - 1) #for (J, 0, Sides - 1)
      #local R = 0.01 + 3*I/(Rings - 1);
      vnormalize(<-Slope(R)*cos(2*pi*J/Sides), 1, -Slope(R)*sin(2*pi*J/Sides)>),
    #end #end
  }
  face_indices {
    2*(Rings - 1)*Sides,
    #for (I, 0, Rings - 2) #for (J, 0, Sides - 1)
      #local K = mod(J + 1, Sides);
      <I*Sides + J, (I + 1)*Sides + J, (I + 1)*Sides + K>, <I*Sides + J, (I + 1)*Sides + K, I*Sides + K>,
    #end #end
  }
  pigment { radial frequency 12 color_map { [0.5 rgb <0.75, 0.30, 0.12>] [0.5 rgb <0.88, 0.62, 0.25>] } }
  finish { ambient 0.08 diffuse 0.65 specular 0.7 roughness 0.015 reflection { 0.02, 0.3 } }
}
torus { 3.02, 0.06 translate 0.06*y pigment { rgb <0.45, 0.33, 0.16> } finish { specular 0.7 roughness 0.02 metallic } }
