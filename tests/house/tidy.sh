#!/bin/bash
# tidy.sh [FOLDER|FILE..]: clang-tidy (.clang-tidy) over everything that is compiled, or over that. From the root folder, after a build of the
# release preset. Nine tenths of its time go into the headers of libraries, so up to eight sources are read as one unit, each of another folder,
# because names clash within one; units that clash all the same are read in halves, down to single ones. An hour of one core for all. Exit code
# 1 on a finding, or if it looked at nothing.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
root=$PWD
[ $# -gt 0 ] || set -- lib mms oned reports verification tests
command -v clang-tidy >/dev/null || { echo "clang-tidy is missing (Debian: clang-tidy)"; exit 1; }
mapfile -t sources < <(git ls-files -- "$@" | grep '\.cpp$' | grep -v -e '^tests/consumer/' -e '^tests/fuzz/fuzz_')
[ ${#sources[@]} -gt 0 ] || { echo "no sources in $*"; exit 1; }
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
flags=(-std=c++20 -fopenmp -march=native -DFMT_SHARED -DPLUMB_FUZZ_TARGET=scene -I "$root" -I "$root/verification" -I "$root/tests"
  -I "$root/build/release/include" -I "$root/build/release/generated" -I "$root/build/release/verification"
  -isystem /usr/include/eigen3 -isystem /usr/include/suitesparse -isystem /usr/include/hdf5/serial)
bad=0 seen=0

# look FILE..: one unit; a unit that does not compile is split, a single file that does not is a finding
look() {
  local unit=$work/unit_$RANDOM$RANDOM.cpp file half ended
  for file in "$@"; do echo "#include \"$root/$file\""; done >"$unit"
  nice -n 10 clang-tidy --quiet --config-file=.clang-tidy --checks=-bugprone-suspicious-include --header-filter="^$root/.*" "$unit" -- "${flags[@]}" >"$unit.txt" 2>"$unit.err"
  ended=$?
  if grep -q '\[clang-diagnostic-error\]' "$unit.txt" && [ $# -gt 1 ]; then
    half=$(($# / 2))
    look "${@:1:half}"
    look "${@:half+1}"
    return
  fi
  seen=$((seen + $#))
  if [ $ended != 0 ] || grep -q 'error:\|warning:' "$unit.txt"; then
    bad=1
    echo "clang-tidy ended with $ended: $*"
    cat "$unit.txt" "$unit.err"
  fi
}

round=0 batch=()
while read -r of file; do
  if [ ${#batch[@]} -gt 0 ] && { [ "$of" != "$round" ] || [ ${#batch[@]} -ge 8 ]; }; then
    look "${batch[@]}"
    batch=()
  fi
  round=$of
  batch+=("$file")
done < <(printf '%s\n' "${sources[@]}" | awk '{ folder = $0; sub("/[^/]*$", "", folder); print ++of[folder], $0 }' | sort -s -k1,1n)
[ ${#batch[@]} = 0 ] || look "${batch[@]}"
[ "$seen" -eq ${#sources[@]} ] || { echo "looked at $seen of ${#sources[@]} sources"; exit 1; }
[ $bad = 0 ] && echo "$seen sources: no finding"
exit $bad
