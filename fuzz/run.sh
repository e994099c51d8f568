#!/usr/bin/env bash
# Fuzzes the reader of scenes with cargo-fuzz (`cargo install cargo-fuzz`; a nightly toolchain, or a stable one with
# RUSTC_BOOTSTRAP=1).
#
#   fuzz/run.sh SECONDS WORK [SCENES …]
#
# WORK holds corpus and findings, outside the repository. It begins with our scenes, the wrong ones, and those in
# the folders SCENES. A scene that takes more than a minute or 2 GB is a finding like a panic.
set -euo pipefail
seconds=$1 work=$(realpath -m "$2")
shift 2
root=$(cd "$(dirname "$0")/.." && pwd)
corpus=$work/corpus
mkdir -p "$corpus" "$work/findings"
n=0
while IFS= read -r -d '' scene; do
  n=$((n + 1))
  head -c 16384 "$scene" >"$corpus/seed-$n"
done < <(find "$root/tests" "$root/scenes" "$@" \( -name '*.pov' -o -name '*.inc' \) -print0)
# Every wrong scene for itself, and every line of the table of words.
awk -v out="$corpus/bad-" '/^=== /{close(f); n++; f=out n; on=1; next} /^---$/{on=0} on{print >f}' \
  "$root"/tests/bad/*.txt
awk -F ' :: ' -v out="$corpus/word-" '/ :: /{n++; f=out n; gsub(/\$O/, "sphere{0,1 pigment{rgb 1}}", $2); print $2 >f; close(f)}' \
  "$root/tests/language/coverage.txt"
awk -F, '!/^#/{printf "\"%s\"\n", $1}' "$root/tests/data/reserved-words.csv" >"$work/words.dict"
cat >>"$work/words.dict" <<'WORDS'
"#declare A ="
"#local A ="
"#macro M(A)"
"#end"
"#while(1)"
"#if(1)"
"array[3]"
"<0,0,0>"
"1e308"
"1e-308"
"-2147483649"
"sphere{0,1}"
"texture{"
"pigment{"
"function{"
"union{"
WORDS
cd "$root"
cargo fuzz run --sanitizer none scene "$corpus" -- -max_total_time="$seconds" -timeout=60 -rss_limit_mb=2048 \
  -max_len=16384 -dict="$work/words.dict" -artifact_prefix="$work/findings/" -print_final_stats=1 -fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1
