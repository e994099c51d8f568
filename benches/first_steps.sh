#!/usr/bin/env bash
# The README's commands as a new user types them: a fresh clone, no target folder, povray not on the PATH, POV-Ray's
# include files out of reach. Prints how long each took; exit code 1 if one fails.
#
#   benches/first_steps.sh [FOLDER]     the clone goes to FOLDER (a temporary one otherwise, removed at the end)
#
# Needs unshare from util-linux: folders are hidden in a mount namespace of its own, nothing is changed outside.
set -eu
cd "$(dirname "$0")/.."
root=$PWD

if [ "${1:-}" != --hidden ]; then
  if [ $# -gt 0 ]; then
    mkdir -p "$1"
    place=$(realpath "$1")
  else
    place=$(mktemp -d)
    trap 'rm -rf "$place"' EXIT
  fi
  flags=-m
  [ "$(id -u)" = 0 ] || flags=-rm
  unshare $flags "$0" --hidden "$place"
  exit
fi

place=$2
for folder in /usr/share/povray-3.7 /usr/local/share/povray-3.7 /usr/share/povray /usr/share/doc/povray \
  /usr/share/doc/povray-examples /etc/povray; do
  [ ! -d "$folder" ] || mount -t tmpfs none "$folder"
done
# Everything on the PATH but povray.
mkdir -p "$place/bin"
IFS=: read -ra folders <<<"$PATH"
for folder in "${folders[@]}"; do
  for program in "$folder"/*; do
    name=${program##*/}
    [ "$name" = povray ] || [ -e "$place/bin/$name" ] || ln -s "$program" "$place/bin/$name" 2>/dev/null || true
  done
done
export PATH=$place/bin
unset CARGO_TARGET_DIR POVINI GLINT_REQUIRE_POVRAY GLINT_REQUIRE_PYTHON GLINT_REQUIRE_CHROMIUM
! command -v povray >/dev/null || { echo "povray is still there" >&2; exit 1; }
[ -z "$(ls -A /usr/share/povray-3.7 2>/dev/null)" ] || { echo "POV-Ray's files are still there" >&2; exit 1; }

git clone --quiet "$root" "$place/glint"
cd "$place/glint"
echo "commit $(git rev-parse --short HEAD), $(nproc) cores, load $(cut -d' ' -f1 /proc/loadavg)"
failed=0
mapfile -t commands < <(awk '/^```/ { inside = !inside; block += inside; next } inside && block == 1 { sub(/ *#.*/, ""); print }' README.md)
[ "${#commands[@]}" = 2 ] || { echo "the README's first block has ${#commands[@]} commands, not 2" >&2; exit 1; }
for command in "${commands[@]}"; do
  began=$SECONDS
  if bash -c "$command" >"$place/log" 2>&1; then
    echo "ok      $((SECONDS - began)) s   $command"
    grep -E '^(test result|skipped)' "$place/log" | sort | uniq -c || true
  else
    echo "FAILED  $((SECONDS - began)) s   $command"
    tail -n 60 "$place/log"
    failed=1
  fi
done
[ -f still_life.png ] || { echo "FAILED  there is no still_life.png"; failed=1; }
exit $failed
