#!/usr/bin/env bash
# One scene at all scales and distances: PSNR against the picture at scale 1 in the middle of the world, Glint's
# and POV-Ray's side by side. The tables of docs/numerics.md.
#
#   benches/extremes.sh [scale] [numbers] [distance]      all three by default
#   GLINT=path POVRAY=path WIDTH=320 HEIGHT=240 …
set -u
cd "$(dirname "$0")/.." || exit 1
povray=${POVRAY:-povray}
if [ -z "${GLINT:-}" ]; then
  cargo build --release --quiet || exit 1
  GLINT=target/release/glint
fi
GLINT=$(realpath "$GLINT")
width=${WIDTH:-160} height=${HEIGHT:-120}
scene=$PWD/tests/extremes/everything.pov
mkdir -p target/extremes
cd target/extremes || exit 1

# glint NAME [NAME=VALUE …]: Glint's picture.
glint() {
  local name=$1
  shift
  "$GLINT" render "$scene" -o "$name.png" -W "$width" -H "$height" --quiet $(printf -- '-D %s ' "$@")
}

# povray NAME [NAME=VALUE …]: POV-Ray's picture; none if it fails.
povray() {
  local name=$1
  shift
  rm -f "$name.png"
  cp "$scene" everything.pov
  timeout 300 "$povray" +Ieverything.pov "+O$name.png" "+W$width" "+H$height" -A -J -D \
    $(printf -- 'Declare=%s ' "$@") </dev/null >/dev/null 2>&1
}

# decibels A B: PSNR, or why there is none.
decibels() {
  [ -f "$2" ] || { echo "no picture"; return; }
  "$GLINT" compare "$1" "$2" --json 2>/dev/null | sed -n 's/.*"psnr_db": *\([-0-9.nul]*\).*/\1/p' | sed 's/null/equal/' | head -n 1
}

# row LABEL NAME [NAME=VALUE …]
row() {
  local label=$1 name=$2
  shift 2
  glint "g_$name" "$@"
  local p="not asked"
  if command -v "$povray" >/dev/null && [ -z "${NO_POVRAY:-}" ]; then
    povray "p_$name" "$@"
    p=$(decibels p_0.png "p_$name.png")
  fi
  echo "| $label | $(decibels g_0.png "g_$name.png") | $p |"
}

glint g_0 K=0
if [ -z "${NO_POVRAY:-}" ]; then povray p_0 K=0; fi
for what in "${@:-scale numbers distance}"; do
  for part in $what; do
    echo "| $part | Glint dB | POV-Ray dB |"
    echo "|---|---|---|"
    case $part in
      scale) for k in $(seq -12 12); do row "10^$k" "s$k" K="$k"; done ;;
      numbers) for k in $(seq -12 12); do row "10^$k" "n$k" K="$k" Deep=1; done ;;
      distance) for k in $(seq 0 10); do row "10^$k" "d$k" Away=1e"$k"; done ;;
    esac
    echo
  done
done
