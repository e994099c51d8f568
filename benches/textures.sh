#!/usr/bin/env bash
# Times Glint and POV-Ray on textures in the same run, one thread each, and prints tables with ratios.
#
#   benches/textures.sh                  both of these (some minutes)
#   benches/textures.sh screen           benches/scenes/fullscreen.pov, every surface, 2560x1920
#   benches/textures.sh examples [DIR]   POV-Ray's example scenes of textures for which it takes 0.2 s or more at 320x240
#   GLINT=path POVRAY=path RUNS=3 …      other programs, number of runs (the fastest counts)
#
# Times are CPU seconds of the trace: POV-Ray's own statistics, Glint's --json.
set -u
cd "$(dirname "$0")/.." || exit 1
what=${1:-all}
examples=${2:-/usr/share/doc/povray/examples}
runs=${RUNS:-3}
povray=${POVRAY:-povray}
command -v "$povray" >/dev/null || { echo "povray is not installed" >&2; exit 3; }
if [ -z "${GLINT:-}" ]; then
  cargo build --release --quiet || exit 1
  GLINT=target/release/glint
fi
GLINT=$(realpath "$GLINT")
work=$(realpath target)/textures
mkdir -p "$work"

# povray_time SCENE WIDTH HEIGHT [NAME=VALUE]: CPU seconds of the trace.
povray_time() {
  (cd "$(dirname "$1")" && "$povray" "+I$(basename "$1")" "+O$work/p.png" "+W$2" "+H$3" -A -J -D +WT1 \
    ${4:+Declare=$4}) 2>&1 </dev/null | tr '\r' '\n' | awk '
      /Trace Time:/ { into = 1 }
      / CPU-seconds total/ && into { for (k = 2; k <= NF; k++) if ($k == "CPU-seconds") print $(k - 1); exit }'
}

# glint_time, the same.
glint_time() {
  (cd "$(dirname "$1")" && "$GLINT" render "$(basename "$1")" -o "$work/g.png" -W "$2" -H "$3" --threads 1 \
    ${4:+-D "$4"} --quiet --json) 2>/dev/null | sed -n 's/.*"trace_cpu_s": *\([0-9.e-]*\).*/\1/p'
}

# one NAME LEAST SCENE WIDTH HEIGHT [NAME=VALUE]: a line of the table, if POV-Ray takes LEAST seconds.
one() {
  local name=$1 least=$2 i
  shift 2
  : >"$work/p"; : >"$work/g"
  for i in $(seq "$runs"); do
    povray_time "$@" >>"$work/p"
    awk -v least="$least" 'END { exit !($1 >= least) }' "$work/p" || return 0
    glint_time "$@" >>"$work/g"
  done
  local p g psnr
  p=$(sort -g "$work/p" | head -n 1)
  g=$(sort -g "$work/g" | head -n 1)
  psnr=$("$GLINT" compare "$work/p.png" "$work/g.png" --json | sed -n 's/.*"psnr_db": *\([0-9.]*\).*/\1/p')
  awk -v name="$name" -v p="$p" -v g="$g" -v psnr="${psnr:-equal}" -v log_file="$work/ratios" 'BEGIN {
    if (p == "" || g == "") { printf "| %s | failed | | | |\n", name; exit }
    printf "| %s | %.3f | %.3f | %.2f | %s |\n", name, p, g, g / p, psnr
    print g / p >>log_file }'
}

heading() {
  : >"$work/ratios"
  printf '\n| %s | POV-Ray trace | trace | ratio | PSNR |\n|---|---|---|---|---|\n' "$1"
}

mean() {
  awk '{ sum += log($1); n++ } END { if (n) printf "\ngeometric mean of %d: %.2f\n", n, exp(sum / n) }' "$work/ratios"
}

screen() {
  heading "surface, 2560x1920"
  local number=0 name
  for name in granite "wood, 10 octaves" crackle bozo agate "turbulent marble" "bumps" "wrinkles" "mandel" \
    "three layers"; do
    number=$((number + 1))
    one "$name" 0 benches/scenes/fullscreen.pov 2560 1920 "Surface=$number"
  done
  mean
}

examples() {
  heading "example, 320x240"
  local scene
  while IFS= read -r scene; do
    one "${scene#"$examples"/}" 0.2 "$scene" 320 240
  done < <(find "$examples"/textures "$examples"/incdemo "$examples"/templates -name '*.pov' | sort)
  mean
}

case $what in
  all) screen; examples ;;
  screen) screen ;;
  examples) examples ;;
  *) echo "unknown: $what" >&2; exit 2 ;;
esac
