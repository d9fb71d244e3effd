#!/usr/bin/env python3
"""Every test is registered, and every label holds tests.

labels.py SOURCE BUILD CTEST: compares what ctest knows of BUILD with the add_test() lines of SOURCE. A test that CMake adds
before enable_testing() is registered nowhere, and `ctest -L LABEL` that finds none ends well. Prints the count of each label.
"""
import collections
import json
import pathlib
import re
import subprocess
import sys

# the least number of tests of each label: half of what there was when it was written, or all where they are few
LEAST = {"tests": 300, "verification": 60, "long": 20, "claims": 2, "stability": 2}
WITH = {"claims": ["claims.Ledger", "claims.LedgerLong"], "stability": ["stability.Maps", "stability.MapsLong"],
        "long": ["claims.LedgerLong", "stability.MapsLong", "house.HeadersAlone"],
        "verification": ["stability.Maps", "faults.ListHolds", "faults.SampleIsCaught"],
        "tests": ["house.Labels", "house.Citations", "package.Consumer"]}


def main(source, build, ctest):
    listed = json.loads(subprocess.run([ctest, "--test-dir", build, "--show-only=json-v1"], capture_output=True,
                                       check=True, text=True).stdout)
    held = collections.defaultdict(set)
    names = set()
    for test in listed["tests"]:
        names.add(test["name"])
        for entry in test.get("properties", []):
            for label in entry["value"] if entry["name"] == "LABELS" else []:
                held[label].add(test["name"])
    wrong = []
    for file in sorted(pathlib.Path(source).rglob("CMakeLists.txt")):
        # consumer is a project of its own, the fuzzers are built with clang only
        if {"build", "consumer", "fuzz"} & set(file.relative_to(source).parts):
            continue
        for name in re.findall(r"add_test\(NAME\s+([\w.]+)", file.read_text()):
            if name not in names:
                wrong.append(f"{name} of {file.relative_to(source)} is registered nowhere")
    for label, least in LEAST.items():
        if len(held[label]) < least:
            wrong.append(f"label {label} holds {len(held[label])} tests, at least {least} are expected")
        wrong += [f"label {label} lacks {name}" for name in WITH[label] if name not in held[label]]
    for label in sorted(held):
        print(f"{len(held[label]):5} {label}")
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
