#!/bin/bash
# headers.sh order SOURCE: every some.cpp of the libraries includes its own some.hpp first, so that a header that lacks an
#   include fails to compile there. Quick, for every run of the tests.
# headers.sh alone SOURCE BUILD COMPILER: every header that is installed compiles by itself. Some minutes, label `long`.
set -euo pipefail
what=$1 source=$2
cd "$source"
headers=$(find lib mms oned reports -name '*.hpp' -not -path 'reports/out/*' | sort)
[ "$(wc -l <<<"$headers")" -ge 100 ] || { echo "found too few headers"; exit 1; }

if [ "$what" = order ]; then
  seen=0 bad=0
  for header in $headers; do
    code=${header%.hpp}.cpp
    [ -f "$code" ] || continue
    first=$(grep -m1 '^#include' "$code" | sed 's/.*["<]\(.*\)[">].*/\1/')
    [ "$first" = "$header" ] || { echo "$code includes $first before its own header"; bad=1; }
    seen=$((seen + 1))
  done
  [ "$seen" -ge 50 ] || { echo "found $seen pairs only"; exit 1; }
  echo "$seen headers are included first by their own source"
  exit $bad
fi

build=$3 compiler=$4
alone() {
  header=$1
  echo "#include \"$header\"" | "$compiler" -std=c++20 -Wall -Wextra -Werror -Wno-psabi -fopenmp -fsyntax-only \
    -I"$build/generated" -I"$source" -isystem /usr/include/eigen3 -x c++ - || { echo "does not compile alone: $header"; exit 255; }
}
export -f alone
export build compiler source
xargs -P "${PLUMBLINE_JOBS:-2}" -I{} bash -c 'alone {}' <<<"$headers"
echo "$(wc -l <<<"$headers") headers compile alone"
