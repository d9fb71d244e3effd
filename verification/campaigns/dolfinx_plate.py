#!/usr/bin/env python3
"""DOLFINx under plumbline's loads: dolfinx_plate.py DEGREE [RESULT.json]: triangles of that degree, Saint Venant-Kirchhoff, equilibrium by Newton's method.

The load is evaluated at quadrature points by the module plumbline. Prints errors and the order in L2, judged against DEGREE + 1; exit code
1 if it is not met. Needs python3-dolfinx-real and python3-plumbline (tests/foreign/run sets both up).
"""
import json
import sys

import basix
import numpy as np
import ufl
from dolfinx import fem, mesh, nls
from mpi4py import MPI

import plumbline

degree, time = int(sys.argv[1]), 0.004
young, poisson = 1e6, 0.3
plate = plumbline.Solution("stretched-column", 2, law="saint-venant-kirchhoff", young=young, poisson=poisson, density=1000, stretch=0.3,
                           contraction=0.2, period=0.02)
mu, lame = young / 2 / (1 + poisson), young * poisson / (1 + poisson) / (1 - 2 * poisson)


def error_of(n):
    domain = mesh.create_rectangle(MPI.COMM_WORLD, [[-0.5, 0], [0.5, 2]], [n, 2 * n])
    V = fem.VectorFunctionSpace(domain, ("Lagrange", degree))
    rule = {"quadrature_degree": 2 * degree + 2}
    dx = ufl.Measure("dx", metadata=rule)
    Q = fem.FunctionSpace(domain, ufl.VectorElement("Quadrature", domain.ufl_cell(), degree=rule["quadrature_degree"], quad_scheme="default"))
    points, weights = basix.make_quadrature(basix.CellType.triangle, rule["quadrature_degree"])
    cells = np.arange(domain.topology.index_map(2).size_local, dtype=np.int32)
    corners = domain.geometry.x[np.array([domain.geometry.dofmap.links(c) for c in cells])][:, :, :2]
    X = corners[:, :1] * (1 - points.sum(axis=1))[None, :, None] + corners[:, 1:2] * points[None, :, :1] + corners[:, 2:3] * points[None, :, 1:]
    load = fem.Function(Q)
    places = Q.dofmap.list.array.reshape(X.shape[:2])
    load.x.array.reshape(-1, 2)[places] = plate.static_load(X.reshape(-1, 2), time).reshape(X.shape)
    u, v = fem.Function(V), ufl.TestFunction(V)
    F = ufl.Identity(2) + ufl.grad(u)
    E = (F.T * F - ufl.Identity(2)) / 2
    S = lame * ufl.tr(E) * ufl.Identity(2) + 2 * mu * E
    edge = fem.Function(V)
    edge.interpolate(lambda x: plate.displacement(np.ascontiguousarray(x[:2].T), time).T)
    facets = mesh.locate_entities_boundary(domain, 1, lambda x: np.full(x.shape[1], True))
    held = fem.dirichletbc(edge, fem.locate_dofs_topological(V, 1, facets))
    problem = fem.petsc.NonlinearProblem(ufl.inner(F * S, ufl.grad(v)) * dx - ufl.inner(load, v) * dx, u, [held])
    solver = nls.petsc.NewtonSolver(MPI.COMM_WORLD, problem)
    solver.convergence_criterion, solver.rtol = "incremental", 1e-10
    solver.solve(u)
    area = np.abs(np.linalg.det(corners[:, 1:] - corners[:, :1]))
    values = fem.Expression(u, points).eval(cells).reshape(len(cells) * len(points), 2)
    return plate.error("displacement", X.reshape(-1, 2), time, values, np.outer(area, weights).ravel()).relative_l2


levels = [4, 8, 16, 32]
errors = [error_of(n) for n in levels]
fit = plumbline.fit_order([1 / n for n in levels], errors, declared=degree + 1)
for n, error in zip(levels, errors):
    print(f"  {n} x {2 * n} x 2 triangles: relative L2 {error:.4e}")
print(f"DOLFINx P{degree}: {fit}")
if len(sys.argv) > 2:  # in the form of a campaign's result
    json.dump({"campaign": f"dolfinx-P{degree}", "solution": "stretched-column", "status": "pass" if fit.verdict == "pass" else "fail",
               "levels": [{"d": 1 / n, "relative_l2": error} for n, error in zip(levels, errors)],
               "fits": [{"norm": "l2", "order": fit.order, "ci95": [fit.lower, fit.upper], "pairwise": fit.pairwise,
                         "declared": degree + 1, "verdict": fit.verdict}]}, open(sys.argv[2], "w"), indent=1)
sys.exit(0 if fit.verdict == "pass" else 1)
