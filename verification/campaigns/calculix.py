#!/usr/bin/env python3
"""Drives CalculiX for calculix.toml: a box of C3D8 or C3D20 elements under the loads of a table, and the result as a table.

calculix.py mesh ELEMENT LAW YOUNG POISSON LOADS.csv: writes job.inp. The table has the nodes of the lattice that the elements are made of:
a C3D20 spans two spacings. calculix.py read ELEMENT LOADS.csv RESULT.csv: writes displacements at the Gauss points with their volumes.
"""
import csv
import itertools
import sys

import numpy as np

CORNERS = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
MIDDLES = [(0, -1, -1), (1, 0, -1), (0, 1, -1), (-1, 0, -1), (0, -1, 1), (1, 0, 1), (0, 1, 1), (-1, 0, 1),
           (-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]


def shapes(element, at):
    """Shape functions at a point of the reference cube."""
    values = []
    for node in CORNERS + (MIDDLES if element == "C3D20" else []):
        factors = [1 + a * n for a, n in zip(at, node)]
        if 0 in node:
            k = node.index(0)
            values.append((1 - at[k] ** 2) * np.prod([f for m, f in enumerate(factors) if m != k]) / 4)
        elif element == "C3D20":
            values.append(np.prod(factors) * (sum(a * n for a, n in zip(at, node)) - 2) / 8)
        else:
            values.append(np.prod(factors) / 8)
    return np.array(values)


def gauss(element):
    """Points and weights: of degree 3, or 5 for quadratic elements."""
    line = [(-1 / 3**0.5, 1), (1 / 3**0.5, 1)] if element == "C3D8" else [(-0.6**0.5, 5 / 9), (0, 8 / 9), (0.6**0.5, 5 / 9)]
    return [([p[0] for p in three], np.prod([p[1] for p in three])) for three in itertools.product(line, repeat=3)]


def lattice(element, loads):
    """Nodes, elements, edge of an element, and the table."""
    rows = list(csv.DictReader(open(loads)))
    table = {name.split(" ")[0]: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    X = np.stack([table[axis] for axis in "XYZ"], axis=1)
    h = np.diff(np.unique(np.round(X[:, 0], 9)))[0]
    place = np.rint((X - X.min(axis=0)) / h).astype(int)
    number = {tuple(p): k for k, p in enumerate(place)}
    span = 2 if element == "C3D20" else 1
    nodes = CORNERS + (MIDDLES if element == "C3D20" else [])
    counts = place.max(axis=0) // span
    elements = np.array([[number[tuple(span * np.array(cell) + span * (np.array(node) + 1) // 2)] for node in nodes]
                         for cell in itertools.product(*map(range, counts))])
    return X, elements, span * h, table, place


def mesh(element, law, young, poisson, loads):
    X, elements, edge, table, place = lattice(element, loads)
    u, s = (np.stack([table[key + axis] for axis in "xyz"], axis=1) for key in "us")
    force = np.zeros_like(X)
    for at, weight in gauss(element):
        N = shapes(element, at)
        np.add.at(force, elements, np.einsum("a,ei->eai", N, np.einsum("b,ebi->ei", N, s[elements])) * weight * edge**3 / 8)
    used = np.unique(elements)
    held = np.any((place == 0) | (place == place.max(axis=0)), axis=1)
    out = ["*NODE, NSET=ALL"] + ["%d,%.12g,%.12g,%.12g" % (k + 1, *X[k]) for k in used]
    out.append(f"*ELEMENT, TYPE={element}, ELSET=BODY")
    for k, element_nodes in enumerate(elements):
        words = [str(k + 1)] + [str(node + 1) for node in element_nodes]
        out += [",".join(words[:11]) + ("," if len(words) > 11 else "")] + ([",".join(words[11:])] if len(words) > 11 else [])
    mu, kappa = young / 2 / (1 + poisson), young / 3 / (1 - 2 * poisson)
    elastic = [f"*ELASTIC\n{young:.12g},{poisson:.12g}"]
    out += ["*MATERIAL, NAME=M"] + (elastic if law == "linear" else [f"*HYPERELASTIC, NEO HOOKE\n{mu / 2:.12g},{2 / kappa:.12g}"])
    out += ["*SOLID SECTION, ELSET=BODY, MATERIAL=M", "*STEP" + (", NLGEOM" if law != "linear" else ""), "*STATIC"]
    out += ["0.25,1."] if law != "linear" else []
    out.append("*BOUNDARY")
    out += ["%d,%d,%d,%.12e" % (k + 1, i + 1, i + 1, u[k, i]) for k in used if held[k] for i in range(3)]
    out.append("*CLOAD")
    out += ["%d,%d,%.12e" % (k + 1, i + 1, force[k, i]) for k in used if not held[k] for i in range(3)]
    out += ["*NODE PRINT, NSET=ALL, FREQUENCY=1000", "U", "*END STEP"]
    open("job.inp", "w").write("\n".join(out) + "\n")


def read(element, loads, result):
    X, elements, edge, _, _ = lattice(element, loads)
    u = np.full_like(X, np.nan)
    for line in open("job.dat"):  # the last block counts
        words = line.split()
        if len(words) == 4 and words[0].isdigit():
            u[int(words[0]) - 1] = [float(word) for word in words[1:]]
    with open(result, "w", newline="") as out:
        writer = csv.writer(out)
        writer.writerow(["X", "Y", "Z", "ux", "uy", "uz", "volume"])
        for at, weight in gauss(element):
            N = shapes(element, at)
            points, moved = np.einsum("a,eai->ei", N, X[elements]), np.einsum("a,eai->ei", N, u[elements])
            writer.writerows([*p, *v, weight * edge**3 / 8] for p, v in zip(points, moved))


if sys.argv[1] == "mesh":
    mesh(sys.argv[2], sys.argv[3], float(sys.argv[4]), float(sys.argv[5]), sys.argv[6])
else:
    read(*sys.argv[2:])
