#!/usr/bin/env python3
"""Makes a bonded network for lammps.toml: lammps.py CLOUD.csv YOUNG DENSITY NETWORK.data.

A square lattice, periodic in y, with springs along its edges and diagonals. Per thickness they have C11 = k1 + k2 and C12 = C44 = k2; with
k2 = mu, k1 = 2 mu that is Poisson's ratio 1/4 in plane strain. The ends x = 0 and x = 1 are held: atoms of type 2.
"""
import csv
import sys

cloud, young, density, network = sys.argv[1], float(sys.argv[2]), float(sys.argv[3]), sys.argv[4]
rows = [{key.split(" ")[0]: float(value) for key, value in row.items()} for row in csv.DictReader(open(cloud))]
xs = sorted({round(row["X"], 9) for row in rows})
h, n = xs[1] - xs[0], len(xs) - 1
mu = young / 2.5
number, atoms = {}, []
for row in rows:  # the row y = 1 is that of y = 0
    i, j = round(row["X"] / h), round(row["Y"] / h)
    if j == n:
        continue
    number[i, j] = int(row["id"])
    atoms.append(f"{number[i, j]} 1 {2 if i in (0, n) else 1} {row['X']:.17g} {row['Y']:.17g} 0")
bonds = []
for i, j in number:
    for kind, (di, dj) in ((1, (1, 0)), (1, (0, 1)), (2, (1, 1)), (2, (1, -1))):
        other = (i + di, (j + dj) % n)
        if other in number:
            bonds.append(f"{len(bonds) + 1} {kind} {number[i, j]} {number[other]}")
with open(network, "w") as out:
    out.write(f"network of springs\n\n{len(atoms)} atoms\n{len(bonds)} bonds\n2 atom types\n2 bond types\n8 extra bond per atom\n\n"
              f"-0.5 1.5 xlo xhi\n0 1 ylo yhi\n-0.5 0.5 zlo zhi\n\nMasses\n\n1 {density * h * h:.17g}\n2 {density * h * h:.17g}\n\n"
              f"Bond Coeffs # harmonic\n\n1 {mu:.17g} {h:.17g}\n2 {mu / 2:.17g} {2**0.5 * h:.17g}\n\nAtoms # bond\n\n")  # K is half of k
    out.write("\n".join(atoms) + "\n\nBonds\n\n" + "\n".join(bonds) + "\n")
