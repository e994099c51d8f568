#!/usr/bin/env bash
# Writes a scene with one mesh2, a wavy sheet of 2*COLUMNS*ROWS triangles, to standard output.
#
#   make_mesh.sh 500 249     249,000 triangles, about 9 MB
#   make_mesh.sh 1000 1000   two million triangles, about 74 MB
set -eu
columns=${1:?columns}
rows=${2:?rows}
LC_ALL=C awk -v nx="$columns" -v nz="$rows" 'BEGIN {
  print "#version 3.7;"
  print "global_settings { assumed_gamma 1 }"
  print "camera { location <0, 2.4, -3.2> look_at <0, -0.1, 0> angle 50 right x }"
  print "light_source { <-4, 6, -3> rgb 1 }"
  print "background { rgb <0.2, 0.3, 0.5> }"
  print "mesh2 {"
  printf "vertex_vectors { %d", (nx + 1)*(nz + 1)
  for (j = 0; j <= nz; j++) {
    z = -2 + 4*j/nz
    for (i = 0; i <= nx; i++) {
      x = -2 + 4*i/nx
      y = 0.16*sin(3.1*x + 0.7)*cos(2.3*z) + 0.05*sin(11*x - 4*z) + 0.012*sin(37*x)*sin(41*z)
      printf ",\n<%.5f,%.5f,%.5f>", x, y, z
    }
  }
  printf "\n}\nface_indices { %d", 2*nx*nz
  for (j = 0; j < nz; j++)
    for (i = 0; i < nx; i++) {
      a = j*(nx + 1) + i
      b = a + nx + 1
      printf ",\n<%d,%d,%d>,\n<%d,%d,%d>", a, a + 1, b + 1, a, b + 1, b
    }
  print "\n}"
  print "pigment { rgb <0.8, 0.6, 0.4> }"
  print "finish { phong 0.5 }"
  print "}"
}'
