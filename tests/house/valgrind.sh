#!/bin/bash
# valgrind.sh [PLUMB]: memcheck over short runs of the program: scenes of every kind with all that they can write, a run that goes on from
# its checkpoint, explain, the table of bad inputs, studies. Two minutes of one core. PLUMB is a binary without AVX-512, which valgrind
# 3.19 does not know: cmake --preset package && cmake --build --preset package --target plumb-house (which builds plumb). Exit code 1 on an error or a lost block.
set -uo pipefail
# Possibly lost are the stacks of OpenMP's threads, which live to the end of the program (CHOLMOD starts four, whatever is asked for).
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
plumb=$(realpath "${1:-build/package/bin/plumb}") || exit 1
work=$(mktemp -d) && trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=1  # with more the program would start itself again, outside of valgrind, to let them sleep
bad=0 seen=0

# clean CODE ARGUMENTS..: plumb with these arguments ends with CODE, and valgrind has nothing to say. `refusals` is of plumb-house, which
# plumb would start outside of valgrind.
clean() {
  local code=$1 program=$plumb
  shift
  [ "$1" = refusals ] && program=$plumb-house
  valgrind --quiet --error-exitcode=99 --leak-check=full --errors-for-leak-kinds=definite,indirect --show-leak-kinds=definite,indirect \
    --log-file="$work/valgrind.txt" "$program" "$@" >"$work/out.txt" 2>&1
  local ended=$?
  seen=$((seen + 1))
  if [ $ended = "$code" ] && ! [ -s "$work/valgrind.txt" ]; then echo "clean: plumb $*" && return; fi
  bad=1
  echo "NOT CLEAN (ended with $ended): plumb $*"
  head -n 60 "$work/valgrind.txt"
  [ $ended = "$code" ] || [ $ended = 99 ] || tail -n 5 "$work/out.txt"
}

scenes=verification/scenes
all_of_it=(--set output.vtk=true --set output.series=true --set output.budget=true --set 'output.every=1e-4' --set 'output.checkpoint=1e-4')
clean 0 run $scenes/bending-column.toml --set body.particles='[3, 3, 18]' --set scene.max_steps=3 "${all_of_it[@]}" --set output.budget=false --out "$work/column"
clean 0 run $scenes/bending-column.toml --set body.particles='[3, 3, 18]' --set scene.max_steps=3 "${all_of_it[@]}" --set output.budget=false --out "$work/column" --resume
clean 0 run $scenes/swinging-plate.toml --set scene.max_steps=3 "${all_of_it[@]}" --csv "$work/state.csv" --json "$work/plate.json" --out "$work/plate"
clean 0 run $scenes/spinning-plate-projection.toml --set body.particles='[12, 12]' --set scene.max_steps=3 --out "$work/projection"
clean 0 run $scenes/spinning-ring.toml --set body.spacing=0.1 --set scene.max_steps=2 --out "$work/ring"
clean 0 run $scenes/pulling-column-compatible.toml --set body.spacing=0.3333333333333333 --set scene.max_steps=2 --out "$work/compatible"
clean 1 run $scenes/free_plate.toml --set method.cfl=4 --set 'scene.end_time=1' --out "$work/unstable"
clean 1 run $scenes/free_plate.toml --set method.cfl=4 --set 'scene.end_time=1' --out "$work/unstable" --resume
# Coarser than written where explain would take minutes here: 0.7 CPU-s instead of 5.5 outside valgrind, 0.4 instead of 1.7.
clean 0 explain $scenes/drilled-block.toml --set body.spacing=0.25 --json "$work/explain.json"
clean 0 explain $scenes/spinning-ring.toml --set body.spacing=0.1 --json "$work/explain.json"
clean 0 explain $scenes/bending-column.toml --set body.particles='[3, 3, 18]' --json "$work/explain.json"
clean 0 explain $scenes/oscillating-plate.toml --json "$work/explain.json"
clean 2 explain "$scenes/none.toml"
clean 0 refusals verification/bad_inputs.toml
clean 0 oned study --field sin:3 --n 20,40,80,160 --estimator standard,improved
clean 0 spectrum $scenes/free_plate.toml --set body.particles='[5, 5]'
clean 0 list
[ "$seen" -ge 15 ] || { echo "ran $seen programs only"; exit 1; }
[ $bad = 0 ] && echo "$seen runs: no error, no lost block"
exit $bad
