#!/usr/bin/env python3
"""Compares two builds of the program bit for bit: same_bits.py BEFORE AFTER [WORK] [--only WORD], with two programs, or
same_bits.py --since COMMIT [--only WORD], which builds that commit and the last one, each in a folder of its own.

Runs the scenes and studies below with both programs and compares every file that they write: series, frames and budgets byte for
byte, JSON without the keys that name the machine, the build or a time, checkpoints by h5diff (package hdf5-tools) without the data
sets that name the build or a time. Exit code 0: all the same; 1: something differs; 2: a call failed in one of them only.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

SCENES = "verification/scenes"
STUDIES = "verification/studies"
RUN = ["output.series=true", "output.vtk=true", "scene.max_steps=60"]
PROJECTED = ["method.gradient=compatible", "body.jitter=0.2", "compatible.volumes=unknown"]


def scene(name, file, *changes, threads=1):
    return name, ["run", f"{SCENES}/{file}.toml", "--out", "out", "--threads", str(threads), "--json", "summary.json"], [*RUN, *changes]


def study(name, file, *changes, command="mms", threads=1, more=()):
    return name, [command, f"{STUDIES}/{file}.toml", *more, "--threads", str(threads), "--json", "study.json", *([] if command == "operators" else ["--unfinished", ""])], [*changes]


CALLS = [
    scene("swing", "swinging-plate", "output.checkpoint=1 ms"),
    scene("swing-verlet-adjoint", "swinging-plate", "method.integrator=verlet", "method.momentum=adjoint", "output.checkpoint=1 ms"),
    scene("swing-jitter", "swinging-plate", "body.jitter=0.2", threads=2),
    scene("bend", "bending-column", threads=2),
    scene("bend-stretch-step", "bending-column", "method.wave_speed=stretch"),
    scene("bend-budget", "bending-column", "output.budget=true"),
    scene("oscillate", "oscillating-plate"),
    scene("twist", "twisting-column-300", "scene.max_steps=20"),
    scene("twist-hourglass", "twisting-column-105-compatible", *PROJECTED),
    scene("pull-hourglass-rk3", "pulling-column-compatible", *PROJECTED, "method.integrator=rk3"),
    scene("spin-projection", "spinning-plate-projection", "output.budget=true", threads=2),
    scene("spin", "spinning-plate", "body.particles=[60,60]", threads=2),
    scene("ring", "spinning-ring"),
    scene("drilled", "drilled-block", "body.spacing=0.2", "scene.max_steps=20"),
    scene("bar", "tensile-bar"),
    scene("inside-out", "bending-column", "method.cfl=3", "scene.max_steps=400"),
    study("plate", "swinging_plate", "study.spacings=[0.2,0.1,0.05]", "study.periods=0.25"),
    study("plate-finite-strain", "swinging_plate_finite_strain", "study.spacings=[0.2,0.1]", "study.periods=0.25"),
    study("plate-mirror", "swinging_plate_mirror", "study.spacings=[0.2,0.1]", "study.periods=0.25"),
    study("plate-band", "swinging_plate_band", "study.spacings=[0.2,0.1]", "study.periods=0.25"),
    study("vortex", "generalized_vortex", "study.spacings=[0.125,0.0625]", "study.periods=0.05"),
    study("column", "stretched_column", "study.periods=0.05"),
    study("temporal", "time_step_plate", "study.parameters.amplitude=0.01", more=["--temporal"]),
    study("static", "static_plate", "study.spacings=[0.2,0.1]", command="static"),
    study("operators", "operators", "study.spacings=[0.2,0.1]", command="operators"),
]
NOT_COMPARED = {"provenance", "timing", "memory", "plumbline", "command", "cpu_s", "wall_s", "setup_s", "solve_s", "seconds", "scale_s"}


def bare(value):
    """The JSON value without what names the machine, the build or a time."""
    if isinstance(value, dict):
        return {key: bare(item) for key, item in value.items() if key not in NOT_COMPARED and not key.endswith("_per_s")}
    return [bare(item) for item in value] if isinstance(value, list) else value


def difference(a, b):
    """What differs between two files in words; None if nothing does."""
    if a.suffix == ".json":
        return None if bare(json.loads(a.read_text())) == bare(json.loads(b.read_text())) else "JSON differs"
    if a.suffix == ".h5":
        call = ["h5diff", "--exclude-path", "/program", "--exclude-path", "/seconds", "--exclude-path", "/recorder", str(a), str(b)]
        result = subprocess.run(call, capture_output=True, text=True)
        return None if result.returncode == 0 else (result.stdout + result.stderr).strip()[:200] or "checkpoints differ"
    return None if a.read_bytes() == b.read_bytes() else "bytes differ"


def run(program, name, words, changes, work):
    """Runs one call in a folder of its own; exit code of the program."""
    folder = work / name
    folder.mkdir(parents=True)
    (folder / "verification").symlink_to(pathlib.Path.cwd() / "verification")
    for change in changes:
        words = [*words, "--set", change]
    result = subprocess.run([program, *words, "--quiet"], cwd=folder, capture_output=True, text=True)
    (folder / "errors.txt").write_text(result.stderr)
    return result.returncode


def files_of(folder):
    return sorted(p.relative_to(folder) for p in folder.rglob("*") if p.is_file() and "verification" not in p.parts)


def compare(before, after, name, words, changes, work):
    """Differences of one call, as sentences."""
    codes = [run(program, name, words, changes, work / side) for program, side in ((before, "before"), (after, "after"))]
    if codes[0] != codes[1]:
        return [f"exit codes {codes[0]} and {codes[1]}"]
    if codes[0] == 2:
        return [f"refused by both: {(work / 'after' / name / 'errors.txt').read_text().strip()[:300]}"]
    left, right = files_of(work / "before" / name), files_of(work / "after" / name)
    found = [f"{p} is written by one of them only" for p in sorted(set(left) ^ set(right))]
    for path in left:
        if path in right and (words := difference(work / "before" / name / path, work / "after" / name / path)):
            found.append(f"{path}: {words}")
    return found


def built(commit, place):
    """The program of a commit, built in a checkout of its own."""
    tree = place / "tree"
    subprocess.run(["git", "worktree", "add", "--detach", tree, commit], check=True, stdout=subprocess.DEVNULL)
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    try:
        subprocess.run(["cmake", "--preset", "release", "-DPLUMBLINE_TESTS=OFF", *launcher], cwd=tree, check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", "--preset", "release", "--target", "plumb"], cwd=tree, check=True, stdout=subprocess.DEVNULL)
        shutil.copy(tree / "build/release/bin/plumb", place / "plumb")
    finally:
        subprocess.run(["git", "worktree", "remove", "--force", tree], check=True)
    return str(place / "plumb")


def main():
    arguments = sys.argv[1:]
    if "--since" in arguments:
        commit = arguments.pop(arguments.index("--since") + 1)
        arguments.remove("--since")
        place = pathlib.Path(tempfile.mkdtemp())
        for side in ("before", "after"):
            (place / side).mkdir()
        arguments = [built(commit, place / "before"), built("HEAD", place / "after"), *arguments]
    only = arguments.pop(arguments.index("--only") + 1) if "--only" in arguments else ""
    arguments = [word for word in arguments if word != "--only"]
    if len(arguments) not in (2, 3) or not shutil.which("h5diff"):
        sys.exit(__doc__ if len(arguments) not in (2, 3) else "missing: h5diff (package hdf5-tools)")
    before, after = (os.path.abspath(p) for p in arguments[:2])
    work = pathlib.Path(arguments[2] if len(arguments) == 3 else tempfile.mkdtemp())
    failed = 0
    for name, words, changes in CALLS:
        if only not in name:
            continue
        found = compare(before, after, name, words, changes, work)
        failed += bool(found)
        print(f"{name}: {'; '.join(found) if found else 'the same'}", flush=True)
    print(f"{failed} calls differ; files in {work}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
