#!/usr/bin/env bash
# Makes the *.expected files again: what POV-Ray prints for every scene of this folder.
#
#   tests/language/make_expected.sh [NAME …]
#
# POV-Ray breaks lines at 80 columns; the scenes keep theirs shorter.
set -u
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$here"/*.pov "$here"/*.inc "$work"
cd "$work" && mkdir target || exit 1
[ $# -gt 0 ] || set -- $(ls ./*.pov | sed 's|./||; s|\.pov$||')
failed=0
for name in "$@"; do
  rm -f debug.txt
  if povray "+I$name.pov" +Oout.png +W4 +H3 -D -A +WT1 Debug_File=debug.txt >log.txt 2>&1 </dev/null; then
    # The macros of meshes say how far they are: only the values are kept.
    [ "$name" != standard_meshes ] || sed -i '/^>/!d' debug.txt
    cp debug.txt "$here/$name.expected"
    longest=$(wc -L <debug.txt)
    [ "$longest" -lt 80 ] || echo "$name: a line has $longest columns"
  else
    failed=1
    echo "$name: $(tr '\r' '\n' <log.txt | grep -A2 'Error' | head -n 3 | tr '\n' ' ')"
  fi
done
exit $failed
