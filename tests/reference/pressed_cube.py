#!/usr/bin/env python3
"""The pressed cube of paper 004, 6.6 (verification/scenes/pressed-cube.toml) by CalculiX: n x n x n quadratic bricks (C3D20), neo-Hookean
rubber, dead load on half of the top. Prints the corner's displacement and the largest one downwards.

pressed_cube.py N [LOAD]: needs ccx (Debian: calculix-ccx) and numpy. Made with CalculiX 2.20:
  N =  4  corner u_y -0.33245 u_z -0.50833  largest 0.54219
  N =  6  corner u_y -0.32915 u_z -0.52987  largest 0.56316
  N =  8  corner u_y -0.32601 u_z -0.53659  largest 0.56961
  N = 10  corner u_y -0.32402 u_z -0.53935  largest 0.57215
  N =  4 under 1 Pa: corner u_y -0.10047 u_z -0.13405  largest 0.13621
"""
import itertools
import subprocess
import sys
import tempfile

import numpy as np

CORNERS = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
MIDDLES = [(1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2), (0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)]

n = int(sys.argv[1])
load = float(sys.argv[2]) if len(sys.argv) > 2 else 2.0
young, poisson = 10.0, 0.3
mu, kappa = young / 2 / (1 + poisson), young / 3 / (1 - 2 * poisson)
cells = [np.array(c) * 2 for c in itertools.product(range(n), repeat=3)]
places = sorted({tuple(c + np.array(p)) for c in cells for p in CORNERS + MIDDLES})
number = {p: k + 1 for k, p in enumerate(places)}
force = {}
for x, y in itertools.product(range(0, 2 * n, 2), range(0, n, 2)):  # faces of the top with Y < 1/2
    for (a, b), share in {(0, 0): -1 / 12, (2, 0): -1 / 12, (2, 2): -1 / 12, (0, 2): -1 / 12,
                          (1, 0): 1 / 3, (2, 1): 1 / 3, (1, 2): 1 / 3, (0, 1): 1 / 3}.items():
        node = number[(x + a, y + b, 2 * n)]
        force[node] = force.get(node, 0) - load * share / n**2
lines = ["*NODE, NSET=ALL"] + ["%d,%.12g,%.12g,%.12g" % (k, *(np.array(p) / (2 * n))) for p, k in number.items()]
lines.append("*ELEMENT, TYPE=C3D20, ELSET=BODY")
for k, c in enumerate(cells):
    nodes = [str(number[tuple(c + np.array(p))]) for p in CORNERS + MIDDLES]
    lines += [",".join([str(k + 1)] + nodes[:10]) + ",", ",".join(nodes[10:])]
lines += ["*MATERIAL, NAME=M", "*HYPERELASTIC, NEO HOOKE", "%.12g,%.12g" % (mu / 2, 2 / kappa), "*SOLID SECTION, ELSET=BODY, MATERIAL=M"]
lines += ["*STEP, NLGEOM, INC=1000", "*STATIC", "0.1,1.,1e-6,0.1", "*BOUNDARY"]
lines += ["%d,1,3,0." % k for p, k in number.items() if p[2] == 0]
lines += ["*CLOAD"] + ["%d,3,%.12e" % item for item in force.items()]
lines += ["*NODE PRINT, NSET=ALL, FREQUENCY=1000", "U", "*END STEP"]
with tempfile.TemporaryDirectory() as folder:
    open(folder + "/job.inp", "w").write("\n".join(lines) + "\n")
    said = subprocess.run(["ccx", "-i", "job"], cwd=folder, capture_output=True, text=True)
    if said.returncode != 0:
        sys.exit(said.stdout[-2000:])
    u = {}
    for line in open(folder + "/job.dat"):  # the last block counts
        words = line.split()
        if len(words) == 4 and words[0].isdigit():
            u[int(words[0])] = [float(word) for word in words[1:]]
corner = u[number[(0, 0, 2 * n)]]
print("N = %2d  corner u_y %.5f u_z %.5f  largest %.5f" % (n, corner[1], corner[2], -min(v[2] for v in u.values())))
