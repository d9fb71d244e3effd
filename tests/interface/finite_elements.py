#!/usr/bin/env python3
"""A finite-element code of somebody else's, verified with plumbline: bilinear squares, linear elasticity, in equilibrium.

Exit code 0 if the displacement converges with order 2 and its gradient with order 1. With an argument a mistake is made on
purpose: "law" takes the load of another law, "late" that of another time, "kPa" is a slip of units.
"""
import sys

import numpy as np

import plumbline

mistake = sys.argv[1] if len(sys.argv) > 1 else None
young, poisson, time = 1e6, 0.3, 0.004
plate = plumbline.Solution("stretched-column", 2, law="linear-elastic", young=young, poisson=poisson, density=1000, stretch=0.1,
                           contraction=0.2, period=0.02)
origin, size = map(np.array, plate.box)
lame, shear = young * poisson / (1 + poisson) / (1 - 2 * poisson), young / 2 / (1 + poisson)
C = np.array([[lame + 2 * shear, lame, 0], [lame, lame + 2 * shear, 0], [0, 0, shear]])
gauss = [(x, y) for x in (-1 / 3**0.5, 1 / 3**0.5) for y in (-1 / 3**0.5, 1 / 3**0.5)]
corners = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)])


def shapes(x, y):
    """Shape functions and their slopes in the reference square."""
    N = (1 + corners[:, 0] * x) * (1 + corners[:, 1] * y) / 4
    return N, np.array([corners[:, 0] * (1 + corners[:, 1] * y), corners[:, 1] * (1 + corners[:, 0] * x)]) / 4


def load(X):
    """Body force per volume at points."""
    f = plate.static_load(X, time * 1.3 if mistake == "late" else time)
    if mistake == "law":
        f = plumbline.Solution("stretched-column", 2, law="saint-venant-kirchhoff", young=young, poisson=poisson, density=1000,
                               stretch=0.1, contraction=0.2, period=0.02).static_load(X, time)
    return f / 1000 if mistake == "kPa" else f


def solve(n):
    """Errors of n by 2n elements."""
    nodes = np.array([(i, j) for j in range(2 * n + 1) for i in range(n + 1)])
    X = origin + nodes / n * size / [1, 2]
    first = np.array([j * (n + 1) + i for j in range(2 * n) for i in range(n)])
    elements = np.stack([first, first + 1, first + n + 2, first + n + 1], axis=1)
    h = 1 / n
    K, f = np.zeros((2 * len(X), 2 * len(X))), np.zeros(2 * len(X))
    stiffness = np.zeros((8, 8))
    for x, y in gauss:
        slopes = shapes(x, y)[1] * 2 / h
        B = np.zeros((3, 8))
        B[0, 0::2], B[1, 1::2], B[2, 0::2], B[2, 1::2] = slopes[0], slopes[1], slopes[1], slopes[0]
        stiffness += B.T @ C @ B * h * h / 4
    places = np.stack([2 * elements, 2 * elements + 1], axis=2).reshape(len(elements), 8)
    np.add.at(K, (places[:, :, None], places[:, None, :]), stiffness)
    for x, y in gauss:
        N = shapes(x, y)[0]
        values = load(np.einsum("a,ead->ed", N, X[elements])) * h * h / 4
        np.add.at(f, places, np.einsum("a,ed->ead", N, values).reshape(len(elements), 8))
    edge = np.any(np.isclose(X, origin) | np.isclose(X, origin + size), axis=1)
    held = np.repeat(edge, 2)
    u = np.where(held, plate.displacement(X, time).ravel(), 0)
    free = ~held
    u[free] = np.linalg.solve(K[np.ix_(free, free)], f[free] - K[np.ix_(free, held)] @ u[held])
    u = u.reshape(-1, 2)
    points, values, gradients = [], [], []
    for x, y in gauss:
        N, slopes = shapes(x, y)
        points.append(np.einsum("a,ead->ed", N, X[elements]))
        values.append(np.einsum("a,ead->ed", N, u[elements]))
        gradients.append(np.eye(2) + np.einsum("ba,ead->edb", slopes * 2 / h, u[elements]))
    points, values, gradients = map(np.concatenate, (points, values, gradients))
    weights = np.full(len(points), h * h / 4)
    return (plate.error("displacement", points, time, values, weights).relative_l2,
            plate.error("F", points, time, gradients, weights).l2)


levels = [2, 4, 8, 16]
errors = np.array([solve(n) for n in levels])
fits = [plumbline.fit_order([1 / n for n in levels], errors[:, k], declared=order) for k, order in ((0, 2), (1, 1))]
for n, (l2, h1) in zip(levels, errors):
    print(f"{n} x {2 * n} elements: relative L2 {l2:.3e}, H1 {h1:.3e}")
print("L2:", fits[0])
print("H1:", fits[1])
sys.exit(0 if all(fit.verdict == "pass" for fit in fits) else 1)
