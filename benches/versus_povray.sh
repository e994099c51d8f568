#!/usr/bin/env bash
# Times Glint and POV-Ray on the same scenes in the same run, one thread each, and prints a table with ratios.
#
#   benches/versus_povray.sh                 all of them (some minutes)
#   benches/versus_povray.sh flake           the sphereflakes: depth 2 to 6
#   benches/versus_povray.sh mesh            the meshes: 249,000 and two million triangles
#   benches/versus_povray.sh parse           reading alone: macros, ten million float operations, include files
#   benches/versus_povray.sh threads         one thread against two, median wall time of five runs
#   GLINT=path POVRAY=path RUNS=3 …          other programs, number of runs (the fastest counts)
#
# Times are CPU seconds: POV-Ray's own statistics (parse; trace), Glint's --json (parse + prepare; trace).
# Pictures are compared; a time counts only beside a picture that is right.
set -u
cd "$(dirname "$0")/.." || exit 1
what=${1:-all}
runs=${RUNS:-3}
povray=${POVRAY:-povray}
command -v "$povray" >/dev/null || { echo "povray is not installed" >&2; exit 3; }
if [ -z "${GLINT:-}" ]; then
  cargo build --release --quiet || exit 1
  GLINT=target/release/glint
fi
GLINT=$(realpath "$GLINT")
work=target/versus
mkdir -p "$work"

# field NAME FILE: the number after "NAME": in a JSON object.
field() { sed -n "s/.*\"$1\": *\"\{0,1\}\([-0-9.e+inf]*\).*/\1/p" "$2" | head -n 1; }

# least FILE: the smallest number in it.
least() { sort -g "$1" | head -n 1; }

# peak_of PID: greatest resident memory of a process while it runs, in kB.
peak_of() {
  local peak=0 now
  while now=$(awk '/VmHWM/ { print $2 }' "/proc/$1/status" 2>/dev/null) && [ -n "$now" ]; do
    peak=$now
    sleep 0.02
  done
  echo "$peak"
}

# one NAME WIDTH HEIGHT SCENE [NAME=VALUE]: both programs, $runs times, then a line of the table.
one() {
  local name=$1 width=$2 height=$3 scene=$4 define=${5:-}
  local p="$work/$name.povray" g="$work/$name.glint"
  : >"$p.parse"; : >"$p.trace"; : >"$p.peak"; : >"$g.parse"; : >"$g.trace"; : >"$g.peak"
  local i
  for i in $(seq "$runs"); do
    (cd "$(dirname "$scene")" && exec "$povray" "+I$(basename "$scene")" "+O$PWD_TOP/$p.png" "+W$width" "+H$height" \
      -A -J -D +WT1 ${define:+Declare=$define}) >"$p.log" 2>&1 </dev/null &
    peak_of $! >>"$p.peak"
    wait $! || { echo "POV-Ray failed on $name" >&2; return 1; }
    tr '\r' '\n' <"$p.log" | awk -v parse="$p.parse" -v trace="$p.trace" '
      /Parse Time:/ { into = parse } /Trace Time:/ { into = trace }
      / CPU-seconds total/ && into { for (k = 2; k <= NF; k++) if ($k == "CPU-seconds") print $(k - 1) >> into; into = "" }'
    "$GLINT" render "$scene" -o "$g.png" -W "$width" -H "$height" --threads 1 ${define:+-D "$define"} --quiet --json \
      >"$g.json" || { echo "Glint failed on $name" >&2; return 1; }
    awk -v a="$(field parse_cpu_s "$g.json")" -v b="$(field prepare_cpu_s "$g.json")" 'BEGIN { print a, a + b }' >>"$g.parse"
    field trace_cpu_s "$g.json" >>"$g.trace"
    field peak_rss_bytes "$g.json" >>"$g.peak"
  done
  local psnr
  psnr=$("$GLINT" compare "$p.png" "$g.png" --json | tee "$g.compare" >/dev/null; field psnr_db "$g.compare")
  awk -v name="$name" -v psnr="${psnr:-equal}" -v pp="$(least "$p.parse")" -v pt="$(least "$p.trace")" \
      -v pm="$(sort -g "$p.peak" | tail -n 1)" -v gm="$(sort -g "$g.peak" | tail -n 1)" \
      -v g1="$(cut -d' ' -f1 "$g.parse" | sort -g | head -n 1)" -v g2="$(cut -d' ' -f2 "$g.parse" | sort -g | head -n 1)" \
      -v gt="$(least "$g.trace")" -v rays="$(field camera_rays "$g.json")" -v shadow="$(field shadow_rays "$g.json")" \
      -v mirror="$(field reflected_rays "$g.json")" 'BEGIN {
    printf "| %-12s | %8.3f | %8.3f | %8.3f | %6.3f | %6.3f | %8.3f | %8.3f | %6.3f | %7.2f | %6.0f | %6.0f | %s |\n",
      name, pp, g1, g2, g1/(pp > 0 ? pp : 1e-9), g2/(pp > 0 ? pp : 1e-9), pt, gt, gt/(pt > 0 ? pt : 1e-9),
      (rays + shadow + mirror)/(gt > 0 ? gt : 1e-9)/1e6, pm/1024, gm/1048576, psnr
  }'
}
PWD_TOP=$PWD

heading() {
  echo "| scene        | POV-Ray parse | parse | + prepare | ratio | ratio | POV-Ray trace | trace | ratio | Mrays/s | POV-Ray MB | MB | PSNR |"
  echo "|---|---|---|---|---|---|---|---|---|---|---|---|---|"
}

flake() {
  local depth
  for depth in 2 3 4 5 6; do one "flake_$depth" 640 480 benches/scenes/sphereflake.pov "Depth=$depth"; done
}

mesh() {
  [ -s "$work/mesh_249k.pov" ] || benches/make_mesh.sh 500 249 >"$work/mesh_249k.pov"
  [ -s "$work/mesh_2m.pov" ] || benches/make_mesh.sh 1000 1000 >"$work/mesh_2m.pov"
  one mesh_249k 1024 1024 "$work/mesh_249k.pov"
  one mesh_2m 1024 1024 "$work/mesh_2m.pov"
}

# Reading alone. The pictures are a few pixels.
parse() {
  {
    echo '#version 3.7; global_settings { assumed_gamma 1 }'
    for i in $(seq 20); do
      for name in colors textures shapes woods metals functions glass stones math golds shapes2 transforms; do
        echo "#include \"$name.inc\""
      done
    done
    echo 'sphere { z*3, 1 }'
  } >"$work/includes.pov"
  one parse_flake 16 12 benches/scenes/sphereflake.pov Depth=5
  one parse_floats 16 12 benches/scenes/float_loop.pov
  one parse_includes 16 12 "$work/includes.pov"
}

# Wall seconds of the trace, one and two threads, five runs each, in turn.
threads() {
  local scene=benches/scenes/sphereflake.pov i n
  : >"$work/t1"; : >"$work/t2"; : >"$work/p1"; : >"$work/p2"
  for i in 1 2 3 4 5; do
    for n in 1 2; do
      "$GLINT" render "$scene" -o "$work/t.png" -W 2800 -H 2100 --threads $n -D Depth=5 --quiet --json >"$work/t.json" || return 1
      field trace_wall_s "$work/t.json" | grep . >>"$work/t$n" || field wall_s "$work/t.json" >>"$work/t$n"
      (cd benches/scenes && "$povray" +Isphereflake.pov "+O$PWD_TOP/$work/t_p.png" +W2800 +H2100 -A -J -D +WT$n \
        Declare=Depth=5) 2>&1 </dev/null | tr '\r' '\n' | sed -n 's/.*Trace Time:.*(\([0-9.]*\) seconds).*/\1/p' >>"$work/p$n"
    done
  done
  for n in t p; do
    awk -v who=$n -v a="$(sort -g "$work/${n}1" | sed -n 3p)" -v b="$(sort -g "$work/${n}2" | sed -n 3p)" 'BEGIN {
      printf "%s: one thread %.2f s, two threads %.2f s, factor %.2f\n", (who == "t" ? "Glint" : "POV-Ray"), a, b, a/b }'
  done
}

case $what in
  all) heading; flake; mesh; parse; threads ;;
  flake) heading; flake ;;
  mesh) heading; mesh ;;
  parse) heading; parse ;;
  threads) threads ;;
  *) echo "unknown: $what" >&2; exit 2 ;;
esac
