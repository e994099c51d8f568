#!/usr/bin/env bash
# Makes the pictures in reference-images/povray with POV-Ray 3.7: 160x120 for tests/scenes, 320x240 for scenes/.
#
#   tests/make-references.sh                 every scene that has no picture yet
#   tests/make-references.sh SCENE.pov …     these scenes, anew
#
# A line "// Options: +A0.1 +R2" in a scene adds POV-Ray options for it. Scenes of twins/ have no picture: they are
# compared with each other. Pictures are stored small: palette if it loses nothing, no ancillary data.
set -u
cd "$(dirname "$0")/.." || exit 1
top=$PWD
command -v povray >/dev/null || { echo "povray is not installed" >&2; exit 3; }

scenes=("$@")
if [ $# -eq 0 ]; then
  while IFS= read -r scene; do
    [ -e "reference-images/povray/${scene%.pov}.png" ] || scenes+=("$scene")
  done < <(find scenes tests/scenes -name '*.pov' -not -path '*/twins/*' | LC_ALL=C sort)
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failed=0
for scene in "${scenes[@]+"${scenes[@]}"}"; do
  scene=${scene#"$top"/}
  picture="reference-images/povray/${scene%.pov}.png"
  case $scene in
    scenes/*) size="+W320 +H240" ;;
    *) size="+W160 +H120" ;;
  esac
  options=$(sed -n 's|^// Options: *||p' "$scene" | head -n 1)
  # shellcheck disable=SC2086  # options are words
  if ! (cd "$(dirname "$scene")" && povray "+I$(basename "$scene")" "+O$work/out.png" $size -A -J -D +WT1 -GA \
        $options >"$work/log" 2>&1 </dev/null); then
    echo "FAILED $scene"; sed -n '/rror/,$p' "$work/log" | head -n 4
    failed=$((failed + 1))
    continue
  fi
  mkdir -p "$(dirname "$picture")"
  if command -v convert >/dev/null; then
    convert "$work/out.png" -strip -define png:compression-level=9 "$picture"
  else
    cp "$work/out.png" "$picture"
  fi
  echo "$picture $(stat -c %s "$picture")"
done
exit $((failed > 0))
