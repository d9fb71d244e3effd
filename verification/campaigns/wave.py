import numpy as np
import plumbline

wave = plumbline.Solution("standing-wave", 2, law="linear-elastic", young=1e6, poisson=0, density=1000, amplitude=0.02)
c, end, spacings, errors = np.sqrt(1e6 / 1000), 0.01, [1 / 8, 1 / 16, 1 / 32, 1 / 64], []
for h in spacings:
    x = np.arange(h / 2, 1, h)                                 # centres of cells [m]
    X = np.stack(np.meshgrid(x, x, indexing="ij"), axis=-1).reshape(-1, 2)
    u, v = wave.displacement(X, 0)[:, 0], wave.velocity(X, 0)[:, 0]
    steps = round(2 * end * c / h)
    for step in range(steps):                                  # the program to be verified: finite differences in x, leapfrog
        t, dt = step * end / steps, end / steps
        rows = u.reshape(x.size, -1)
        padded = np.vstack([-rows[:1], rows, -rows[-1:]])      # u = 0 on the walls
        force = c**2 * np.diff(padded, 2, axis=0).ravel() / h**2 + wave.body_force(X, t)[:, 0] / 1000
        v = v + force * (dt / 2 if step == 0 else dt)
        u = u + dt * v
    both = np.column_stack([u, 0 * u])
    errors.append(wave.error("displacement", X, end, both, np.full(u.size, h * h)).l2)
    np.savetxt(f"wave-{x.size}.csv", np.column_stack([X, both]), delimiter=",", header="X,Y,ux,uy", comments="")
print(plumbline.fit_order(spacings, errors, declared=2))
