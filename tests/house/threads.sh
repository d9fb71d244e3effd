#!/bin/bash
# threads.sh: the parallel loops of the library under the thread sanitizer, with four threads. GCC's OpenMP runtime is not instrumented, and its
# barriers would be taken for races; clang's tells the sanitizer of them by libarcher (Debian: clang, libomp-dev). Half an hour of
# one core, most of it for the build of the preset `threads`. Exit code 1 on a race, or if a program was not run.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
[ -e build/threads/CMakeCache.txt ] || cmake --preset threads >/dev/null || exit
archer=$(ls /usr/lib/llvm-*/lib/libarcher.so | tail -n 1)
[ -e "$archer" ] || { echo "libarcher is missing (libomp-dev)"; exit 1; }
rooms=(solid gradient compatible projection time dissipation hourglass boundary geometry diagnostics)
# Of large rooms the tests that go through every parallel loop.
declare -A filter=([compatible]='ProjectionSolvers/*BitsForAny*:ProjectionSolvers/*OperatorIs*:ProjectionSolvers/*Quadratic*' [geometry]='*Neighbour*' [solid]='*Threads*:*Sweeps*:*Solid*:*Run*')
cmake --build --preset threads --target "${rooms[@]/#/tests_lib_}" tests_mms || exit
export OMP_NUM_THREADS=4 OMP_TOOL_LIBRARIES=$archer TSAN_OPTIONS=ignore_noninstrumented_modules=1:exitcode=66
bad=0
for room in "${rooms[@]/#/lib_}" mms; do
  program=build/threads/tests/tests_$room
  out=$("$program" --gtest_filter="${filter[${room#lib_}]:-*}" 2>&1)
  code=$?
  ran=$(sed -n 's/^\[==========\] \([0-9]*\) tests* from.*ran.*/\1/p' <<<"$out")
  if [ "$code" = 0 ] && [ "${ran:-0}" -gt 0 ]; then
    echo "no race: tests_$room, $ran tests"
  else
    bad=1
    echo "NOT CLEAN: tests_$room ended with $code"
    grep -m 1 -A 40 'ThreadSanitizer\|Failure' <<<"$out"
  fi
done
exit $bad
