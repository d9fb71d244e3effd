#!/usr/bin/env python3
"""A shallow arch with clamped ends under a force in its middle: bending and one thrust, solved exactly. Prints the two limit points
that verification/scenes/shallow-arch.toml expects.

Half of it from the foot to the middle, x from 0 to a: EI v'''' + H v'' = H y0'' for the sinking v of y0 = h sin^2(pi x/(2 a)); v(0) = v'(0) = v'(a) = 0,
EI v'''(a) = -P/2; the thrust is H = EA/a int (y0'^2 - y'^2)/2 dx, y = y0 - v. For each H that is a quadratic equation for P."""
import sys

try:
    import numpy as np
except ImportError:
    sys.exit(77)  # left out

E, THICK, A, RISE = 1e6, 0.04, 2.0, 0.1
EA, EI, Q = E * THICK, E * THICK**3 / 12, np.pi / A
x = np.linspace(0, A, 4001)
simpson = np.ones_like(x)
simpson[1:-1:2], simpson[2:-1:2] = 4, 2
simpson *= x[1] / 3
slope0 = RISE * Q / 2 * np.sin(Q * x)

points = []  # sunk, load
for k in np.linspace(0.01, np.pi - 0.005, 4000):
    H = EI * k * k
    C = H * RISE / 2 / (EI * Q * Q - H)
    ka = k * A
    # v = c0 + c1 x + c2 cos kx + c3 sin kx + C cos qx
    M = np.array([[1, 0, 1, 0], [0, 1, 0, k], [0, 1, -k * np.sin(ka), k * np.cos(ka)],
                  [0, 0, k**3 * np.sin(ka), -(k**3) * np.cos(ka)]])
    fixed, by_load = np.linalg.solve(M, [-C, 0, 0, 0]), np.linalg.solve(M, [0, 0, 0, -0.5 / EI])
    slope = lambda c, C: c[1] - c[2] * k * np.sin(k * x) + c[3] * k * np.cos(k * x) - C * Q * np.sin(Q * x)
    v0, vP = slope(fixed, C), slope(by_load, 0)
    a2, a1 = -0.5 * simpson @ (vP * vP), simpson @ ((slope0 - v0) * vP)
    a0 = simpson @ (slope0 * v0 - 0.5 * v0 * v0) - H * A / EA
    if a1 * a1 < 4 * a2 * a0:
        continue
    for sign in (-1, 1):
        load = (-a1 + sign * np.sqrt(a1 * a1 - 4 * a2 * a0)) / 2 / a2
        c = fixed + load * by_load
        points.append((c[0] + c[1] * A + c[2] * np.cos(ka) + c[3] * np.sin(ka) - C, load))
upper = max((p for p in points if p[0] < RISE), key=lambda p: p[1])
lower = min((p for p in points if 0.5 * RISE < p[0] < 2 * RISE), key=lambda p: p[1])
print(f"limit point: {upper[1]:.4f} N at {upper[0]:.4f} m; the other: {lower[1]:.4f} N at {lower[0]:.4f} m")
sys.exit(0 if abs(upper[1] - 3.598) < 1e-3 and abs(upper[0] - 0.0539) < 5e-4 and abs(lower[1] + 0.419) < 1e-3 else 1)
