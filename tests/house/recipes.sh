#!/bin/bash
# recipes.sh SOURCE WORK BUILD_TYPE LAUNCHER: follows CONTRIBUTING.md in a copy of the tree. Every fenced block whose first line
# names a file becomes that file, a block of language diff changes it; then the steps of the recipes are done.
set -euo pipefail
source=$1 work=$2 build_type=$3 launcher=${4:-}
tree=$work/tree build=$work/build
mkdir -p "$work"
rm -rf "$tree"
mkdir "$tree"
for part in .ci CMakeLists.txt CMakePresets.json CONTRIBUTING.md lib mms oned reports verification tests; do
  cp -r "$source/$part" "$tree/"
done

mkdir -p "$tree/verification/scenes"
awk -v tree="$tree" '
  /^```diff / { file = tree "/changes.diff"; next }
  /^```[a-z]+ [^ ]*\// { file = tree "/" $2; next }
  /^```/ { file = "" }
  file != "" { print > file }' "$tree/CONTRIBUTING.md"
for file in lib/kernel/kernels/lucy.hpp lib/material/models/yeoh.hpp \
  lib/material/models/softened.hpp verification/material/softened.toml \
  lib/schemes/tlsph/bonds/estimators/least_squares.hpp lib/schemes/tlsph/parts/drag.hpp lib/schemes/tlsph/parts/drag.cpp changes.diff \
  verification/scenes/stretched-bar.toml; do
  [ -s "$tree/$file" ] || { echo "CONTRIBUTING.md does not show $file"; exit 1; }
done
patch -p1 -d "$tree" <"$tree/changes.diff"

cmake -S "$tree" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE="$build_type" ${launcher:+-DCMAKE_CXX_COMPILER_LAUNCHER="$launcher"}
cmake --build "$build" -j "${PLUMBLINE_JOBS:-2}" --target plumb tests_laws
plumb=$build/bin/plumb

passed() {  # passed FILTER: the law tests of that name exist and pass
  "$build/tests/tests_laws" --gtest_filter="$1" | tee "$work/laws.txt"
  grep -q '^\[  PASSED  \] [1-9]' "$work/laws.txt"
}
passed '*lucy*'
passed '*yeoh*'
passed '*HistoryLaws*softened*'
"$plumb" oned kernels --kernel lucy --at 0.5 --quiet --json "$work/lucy.json"
grep -q lucy "$work/lucy.json"
passed '*least_squares*'  # names of tests have no hyphens
"$plumb" list | grep >/dev/null 'least-squares *Least-squares fit of F'
"$plumb" oned study --field sin:3 --n 20,40,80,160 --estimator improved,least-squares --quiet --json "$work/scheme.json"
grep -q least-squares "$work/scheme.json"
cd "$tree"  # the lines of the recipe name files from there
"$plumb" oned response --estimator improved,least-squares >"$work/response.txt"
"$plumb" spectrum verification/scenes/free_cube.toml --set method.momentum=adjoint --over method.gradient=improved,least-squares
"$plumb" mms verification/studies/swinging_plate_adjoint.toml --set method.gradient=least-squares --set 'study.spacings=[0.4, 0.25, 0.2, 0.1]' \
  --json "$work/order.json" || [ $? = 1 ]  # whether it reaches the declared order is what the study is for
grep -q '"levels"' "$work/order.json"
scene=$tree/verification/scenes/stretched-bar.toml
"$plumb" explain "$scene"
"$plumb" run "$scene" --json "$work/run.json" --out "$work/out"
grep -q '"completed"' "$work/run.json"
"$plumb" run "$scene" --set material.model=yeoh --set material.stiffening="2 MPa" --json "$work/material.json" --out "$work/out"
grep -q '"completed"' "$work/material.json"
! cmp -s "$work/run.json" "$work/material.json"
# the part of the recipe takes kinetic energy away; without its section nothing of it is there
plate=verification/scenes/spinning-plate.toml small='--set body.particles=[20,20] --set scene.max_steps=50'
"$plumb" explain $plate $small --set drag.coefficient=5 | grep >/dev/null 'quadratic, coefficient 5 1/m'
"$plumb" run $plate $small --set drag.coefficient=5 --json "$work/drag.json" --out "$work/out"
"$plumb" run $plate $small --json "$work/plain.json" --out "$work/out"
python3 - "$work/drag.json" "$work/plain.json" <<'CHECK'
import json, sys
drag, plain = (json.load(open(name)) for name in sys.argv[1:])
assert drag["energy"]["kinetic"] < 0.9 * plain["energy"]["kinetic"], "the drag takes no energy"
assert "drag" in drag["built"] and "drag" in plain["left_out"]
CHECK
"$plumb" material verification/material/sheet.toml --set material.model=yeoh --quiet --json "$work/point.json"
grep -q '"cauchy"' "$work/point.json"
# the law with history: the way back is softer, and a body of it runs, stops and goes on
"$plumb" material verification/material/softened.toml --quiet --json "$work/softened.json"
python3 - "$work/softened.json" <<'CHECK'
import json, sys
rows = json.load(open(sys.argv[1]))["rows"]
stress = [row["cauchy"][0][0] for row in rows]
there, back = stress[len(stress) // 4], stress[-1 - len(stress) // 4]
assert 0 < back < 0.9 * there, (there, back)
CHECK
"$plumb" run verification/scenes/turning-block.toml --set mixed.kinematics=tied --set material.model=softened --set material.softening=0.5 \
  --set material.softening_energy="1 kPa" --set scene.max_steps=20 --json "$work/body.json" --out "$work/out"
grep -q '"completed"' "$work/body.json"
