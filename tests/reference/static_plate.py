#!/usr/bin/env python3
"""Static plate by the operator of paper 004, written down with numpy and with nothing of the library: the values that
tests/mms/static_values_test.cpp expects.

Field of the swinging plate on [0, 2]^2, nu = 0.3, linear elasticity, plane strain, a node lattice of 0.2 m, quintic
kernel, supports of 2.05 spacings, exact displacements on the edge; relative error of u, weighted by volumes."""
import sys

try:
    import numpy as np
except ImportError:
    sys.exit(77)  # left out

CELLS, SPACING, RADIUS, POISSON = 10, 0.2, 2.05 * 0.2, 0.3
MU = 0.5 / (1 + POISSON)
LAME = POISSON / ((1 + POISSON) * (1 - 2 * POISSON))


def slope_of_kernel(q):
    """dW/dq of the quintic, up to a factor that cancels."""
    power = lambda a: np.maximum(a - q, 0) ** 4
    return -(power(3) - 6 * power(2) + 15 * power(1))


at = np.arange(CELLS + 1) * SPACING
X = np.array([(x, y) for y in at for x in at])
N = len(X)
width = np.full(CELLS + 1, SPACING)
width[[0, -1]] /= 2
V = np.outer(width, width).ravel()
R = X[None] - X[:, None]
r = np.linalg.norm(R, axis=2)
apart = np.where(r > 0, r, 1)
slope = np.where((r > 0) & (r < RADIUS), slope_of_kernel(3 * r / RADIUS) * V[None] / apart, 0)
L = np.einsum("ij,ija,ijb->iab", slope, R, R)
c = np.einsum("iab,ij,ijb->ija", np.linalg.inv(L), slope, R)  # (12): F_i = sum_j (x_j - x_i) (x) c_ij

a, b = np.pi / 2 * X.T
u = np.stack([-np.sin(a) * np.cos(b), np.cos(a) * np.sin(b)], 1)
load = V[:, None] * MU * np.pi**2 / 2 * u  # -Div P

gradient = np.transpose(c, (0, 2, 1)).copy()  # particle, component, particle
for i in range(N):
    gradient[i, :, i] -= c[i].sum(0)


def relative_error(alpha):
    one = np.eye(2)
    law = LAME * np.einsum("ab,cd->abcd", one, one)
    law += MU * (np.einsum("ac,bd->abcd", one, one) + np.einsum("ad,bc->abcd", one, one))
    K = np.einsum("ibm,abcd,i,idn->manc", gradient, law, V, gradient, optimize=True)
    weight = slope * r**2
    spring = 2 * alpha * MU * V[:, None] * weight / weight.sum(1, keepdims=True) / apart**2  # (21), summed with V_i
    shape = L / np.trace(L, axis1=1, axis2=2)[:, None, None]
    hourglass = np.diag(spring.sum(0) + spring.sum(1)) - spring - spring.T
    hourglass -= 2 * alpha * MU * np.einsum("ibm,i,ibd,idn->mn", gradient, V, shape, gradient, optimize=True)
    for k in range(2):
        K[:, k, :, k] += hourglass
    K = K.reshape(2 * N, 2 * N)
    held = np.repeat((X < 1e-9).any(1) | (X > 2 - 1e-9).any(1), 2)
    found = u.ravel().copy()
    rest = load.ravel()[~held] - K[np.ix_(~held, held)] @ found[held]
    found[~held] = np.linalg.solve(K[np.ix_(~held, ~held)], rest)
    error = (found - u.ravel()).reshape(N, 2)
    return np.sqrt((V[:, None] * error**2).sum() / (V[:, None] * u**2).sum())


right = True
for alpha, expected in [(0, 0.07048283517260), (1, 0.02923291825550)]:
    value = relative_error(alpha)
    right &= abs(value - expected) < 1e-13
    print(f"alpha {alpha}: {value:.14f}")
sys.exit(0 if right else 1)
