#!/usr/bin/env python3
"""A finite-element code that knows nothing of Plumbline: bilinear squares, linear elasticity, equilibrium under a body force.

finite_elements.py INPUT.json [MISTAKE]: reads nodes, loads (sx, sy) and edge displacements (ux, uy) from a table, writes displacements.
MISTAKE, for tests of the judge: "load" puts the inertia into the load, "units" reads a modulus in kPa, "late" moves the edges too far.
"""
import csv
import json
import sys

import numpy as np

given = json.load(open(sys.argv[1]))
mistake = sys.argv[2] if len(sys.argv) > 2 else None
rows = list(csv.DictReader(open(given["loads"])))
table = {name.split(" ")[0]: np.array([float(row[name]) for row in rows]) for name in rows[0]}
X = np.stack([table["X"], table["Y"]], axis=1)
u_edge = np.stack([table["ux"], table["uy"]], axis=1) * (1.1 if mistake == "late" else 1)
load = np.stack([table["sx"], table["sy"]], axis=1)
if mistake == "load":
    load = np.stack([table["bx"], table["by"]], axis=1)
E, nu, h = given["young"] / (1000 if mistake == "units" else 1), given["poisson"], given["h"]
lame, shear = E * nu / (1 + nu) / (1 - 2 * nu), E / 2 / (1 + nu)
C = np.array([[lame + 2 * shear, lame, 0], [lame, lame + 2 * shear, 0], [0, 0, shear]])

# the nodes in any sequence: their places on the lattice make the elements
place = np.rint((X - X.min(axis=0)) / h).astype(int)
number = {tuple(p): k for k, p in enumerate(place)}
elements = np.array([[number[i + di, j + dj] for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))]
                     for i, j in number if (i + 1, j + 1) in number])
corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])
K_e, M_e = np.zeros((8, 8)), np.zeros((4, 4))
for x in (-1 / 3**0.5, 1 / 3**0.5):
    for y in (-1 / 3**0.5, 1 / 3**0.5):
        N = (1 + corners[:, 0] * x) * (1 + corners[:, 1] * y) / 4
        slopes = np.array([corners[:, 0] * (1 + corners[:, 1] * y), corners[:, 1] * (1 + corners[:, 0] * x)]) / 4 * 2 / h
        B = np.zeros((3, 8))
        B[0, 0::2], B[1, 1::2], B[2, 0::2], B[2, 1::2] = slopes[0], slopes[1], slopes[1], slopes[0]
        K_e += B.T @ C @ B * h * h / 4
        M_e += np.outer(N, N) * h * h / 4
K, f = np.zeros((2 * len(X), 2 * len(X))), np.zeros((len(X), 2))
dofs = np.stack([2 * elements, 2 * elements + 1], axis=2).reshape(len(elements), 8)
np.add.at(K, (dofs[:, :, None], dofs[:, None, :]), K_e)
np.add.at(f, elements, np.einsum("ab,ebi->eai", M_e, load[elements]))
edge = np.any((place == 0) | (place == place.max(axis=0)), axis=1)
held, u = np.repeat(edge, 2), np.where(np.repeat(edge, 2), u_edge.ravel(), 0)
u[~held] = np.linalg.solve(K[np.ix_(~held, ~held)], f.ravel()[~held] - K[np.ix_(~held, held)] @ u[held])
with open(given["result"], "w", newline="") as out:
    writer = csv.writer(out)
    writer.writerow(["X [m]", "Y [m]", "ux [m]", "uy [m]"])
    writer.writerows([f"{value:.17g}" for value in (*at, *moved)] for at, moved in zip(X, u.reshape(-1, 2)))
