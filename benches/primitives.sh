#!/usr/bin/env bash
# Every primitive's own small scene: CPU trace time of Glint against POV-Ray's, one thread each, in the same run,
# and how far the pictures are apart.
#
#   benches/primitives.sh                 all of them
#   benches/primitives.sh torus blob      some
#   GLINT=path POVRAY=path RUNS=3 …       other programs, number of runs (the fastest counts)
#
# The scenes are in benches/scenes/primitives.pov, chosen with Shape=n; the objects fill the picture, cast
# shadows on a floor and show in a mirror, so that all kinds of rays meet them.
set -u
cd "$(dirname "$0")/.." || exit 1
runs=${RUNS:-3}
povray=${POVRAY:-povray}
command -v "$povray" >/dev/null || { echo "povray is not installed" >&2; exit 3; }
if [ -z "${GLINT:-}" ]; then
  cargo build --release --quiet || exit 1
  GLINT=target/release/glint
fi
GLINT=$(realpath "$GLINT")
mkdir -p target/primitives
cp benches/scenes/primitives.pov target/primitives/
cd target/primitives || exit 1
size="${WIDTH:-320} ${HEIGHT:-240}"
read -r width height <<<"$size"

# Names in the order of the scene's numbers.
names=$(sed -n 's/.*#case *([0-9]*) *\/\/ *//p' primitives.pov)

least() { sort -g | head -n 1; }

echo "| primitive | Glint s | POV-Ray s | ratio | dB |"
echo "|---|---|---|---|---|"
number=0
for name in $names; do
  number=$((number + 1))
  if [ $# -gt 0 ] && ! grep -qw "$name" <<<"$*"; then continue; fi
  for i in $(seq "$runs"); do
    "$povray" +Iprimitives.pov "+Op_$name.png" "+W$width" "+H$height" -A -J -D +WT1 "Declare=Shape=$number" \
      </dev/null 2>&1 | tr '\r' '\n' | awk '/Trace Time:/ { on = 1 } on && / CPU-seconds total/ {
        for (k = 2; k <= NF; k++) if ($k == "CPU-seconds") print $(k - 1); on = 0 }' >>"p.$name.$$"
    "$GLINT" render primitives.pov -o "g_$name.png" -W "$width" -H "$height" --threads 1 -D "Shape=$number" \
      --aa-method 1 --quiet --json | sed -n 's/.*"trace_cpu_s": *\([-0-9.e]*\).*/\1/p' >>"g.$name.$$"
  done
  g=$(least <"g.$name.$$") p=$(least <"p.$name.$$")
  rm -f "g.$name.$$" "p.$name.$$"
  db=$("$GLINT" compare "g_$name.png" "p_$name.png" --json | sed -n 's/.*"psnr_db": *\([-0-9.nul]*\).*/\1/p')
  awk -v n="$name" -v g="$g" -v p="$p" -v d="${db/null/equal}" \
    'BEGIN { printf "| %s | %.3f | %.3f | %.2f | %s |\n", n, g, p, g / p, d == "equal" ? d : sprintf("%.1f", d) }'
done | tee table.md
awk -F'|' '{ s += log($5); n++; if ($5 > worst) worst = $5 } END { if (n) printf "geometric mean %.2f, worst %.2f of %d\n", exp(s / n), worst, n }' table.md
