#!/usr/bin/env python3
"""readme_numbers.py SOURCE: what README and verification/README say in numbers is what is stored: planted faults as score.json counts them, intervals of
orders as the table of what was measured has them."""
import json
import pathlib
import re
import sys

CLOUDS = r"static plate|moving plate|linear plate|column|cube|vortex|the same"


def faults(source):
    """Planted faults that a test has seen, and all of them."""
    rows = json.loads((source / "verification/faults/score.json").read_text())["faults"]
    return sum(bool(r["caught_by"]) for r in rows), len(rows)


def intervals(source):
    """For each of the two schemes without projection: intervals that end below 1.9 on irregular clouds, and all studies there.
    Clipped rings, on which nothing is claimed, do not count."""
    counts, solution = {"adjoint": [0, 0], "paper": [0, 0]}, ""
    for line in (source / "lib/theory/measured-compatible-bonds.md").read_text().splitlines():
        cells = [c.strip() for c in line.strip("|").split("|")]
        if len(cells) != 6 or not re.match(CLOUDS, cells[0]):
            continue
        solution = solution if cells[0].startswith("the same") else cells[0]
        if cells[0].endswith("lattice") or "clipped" in solution:
            continue
        for scheme, cell in zip(counts, cells[3:5]):
            found = re.search(r"\[(-?[\d.]+), (-?[\d.]+)\]", cell)
            counts[scheme][0] += bool(found) and float(found[2]) < 1.9
            counts[scheme][1] += 1
    return counts


def main():
    source = pathlib.Path(sys.argv[1])
    text = " ".join(" ".join((source / page).read_text() for page in ("README.md", "verification/README.md")).split())
    caught, planted = faults(source)
    by = intervals(source)
    expected = [f"{caught} of {planted} faults planted one at a time",
                f"on {by['adjoint'][0]} of {by['adjoint'][1]} with the improved adjoint form and on {by['paper'][0]} of {by['paper'][1]} "
                "with the paper's scheme",
                f"{by['adjoint'][0] + by['paper'][0]} of {by['adjoint'][1] + by['paper'][1]} intervals exclude it"]
    missing = [e for e in expected if e not in text]
    print("\n".join(f'README does not say "{m}"' for m in missing) or f"{len(expected)} sentences of README hold")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
