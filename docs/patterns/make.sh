#!/usr/bin/env bash
# Renders a swatch of every line of list.txt and writes ../patterns.md.
#
#   docs/patterns/make.sh               with target/release/glint, which it builds
#   GLINT=path docs/patterns/make.sh    with another
set -euo pipefail
cd "$(dirname "$0")"
if [ -z "${GLINT:-}" ]; then
  (cd ../.. && cargo build --release --quiet)
  GLINT=../../target/release/glint
fi
size=72
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# heading KIND: what stands over the kind's swatches.
heading() {
  case $1 in
    pattern) echo "Patterns" ;;
    turbulent) echo "Turbulence" ;;
    generator) echo "Noise generators" ;;
    warp) echo "Warps" ;;
    wave) echo "Waves, frequency and phase" ;;
    map) echo "Maps" ;;
    normal) echo "Normals" ;;
  esac
}

# scene KIND TEXT: a square of two units; slopes and angles need a body, bumps a light.
scene() {
  echo '#version 3.7; global_settings { assumed_gamma 1 }'
  echo 'camera { orthographic location -10*z look_at 0 right 2*x up 2*y }'
  if [ "$1" = normal ]; then
    echo 'light_source { <-6, 5, -4>, 1 parallel point_at 0 }'
    echo "plane { z, 0 pigment { rgb <0.9, 0.75, 0.6> } normal { $2 } finish { ambient 0.1 diffuse 0.8 phong 0.3 } }"
  elif [[ $2 = aoi* || $2 = slope* ]]; then
    echo "sphere { 0, 1 pigment { $2 } finish { ambient 1 diffuse 0 } }"
  else
    echo "plane { z, 0 pigment { $2 } finish { ambient 1 diffuse 0 } }"
  fi
}

{
  echo '# Patterns, warps, waves and normals'
  echo
  echo 'Made by `docs/patterns/make.sh` from `docs/patterns/list.txt`; every swatch shows -1 to 1 along x and y, at z = 0'
  echo 'seen from the front. Formulas, parameters and sources stand at the head of each file of `src/pattern`;'
  echo '`cargo bench --bench pattern` times every line.'
  last=
  while IFS='|' read -r kind name text; do
    kind=${kind// /}
    name=$(sed 's/^ *//; s/ *$//' <<<"$name")
    text=$(sed 's/^ *//; s/ *$//' <<<"$text")
    file=$(tr -cs 'a-z0-9\n' '-' <<<"$kind-$name" | sed 's/-*$//')
    scene "$kind" "$text" >"$work/swatch.pov"
    "$GLINT" render "$work/swatch.pov" -o "$file.png" -W $size -H $size --quiet >/dev/null
    if [ "$kind" != "$last" ]; then
      printf '\n## %s\n\n| | | |\n|---|---|---|\n' "$(heading "$kind")"
      last=$kind
    fi
    printf '| ![%s](patterns/%s.png) | %s | `%s` |\n' "$name" "$file" "$name" "${text//|/\\|}"
  done < <(grep -v '^#' list.txt)
} >"$work/patterns.md"
mv "$work/patterns.md" ../patterns.md
