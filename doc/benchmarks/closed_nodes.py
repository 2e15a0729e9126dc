#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How many of the 121 nodes of prm/benchmarks/block_on_floor.prm are closed, by
Siconos' Gauss-Seidel in a Moreau-Jean scheme, over its theta and the damping of
the block. README.md says what is compared.

usage: /usr/bin/python3 doc/benchmarks/closed_nodes.py
"""
import numpy as np
import scipy.sparse as sp
import siconos.numerics as numerics
from scipy.sparse.linalg import splu

from transient_peers import FORCE, MU, SPEED, STEP, block, ramp

WINDOWS = ((100, 300), (300, 1000), (1000, 2000), (2000, 3000))  # steps


def run(theta, beta, tolerance=1e-10):
    """Closed nodes, normal and tangential force after each step. A node takes
    part in a step if half of it at the present velocity closes its gap."""
    M, K, load, contact = block()
    C = beta * K
    factor = splu((M + theta * STEP * C + theta**2 * STEP**2 * K).tocsc(),
                  permc_spec="MMD_AT_PLUS_A")
    rows = contact.ravel()
    H = sp.csc_matrix((np.ones(rows.size), (rows, np.arange(rows.size))),
                      (M.shape[0], rows.size))
    W = H.T @ factor.solve(H.toarray())
    W = 0.5 * (W + W.T)
    options = numerics.SolverOptions(numerics.SICONOS_FRICTION_3D_NSGS)
    options.iparam[numerics.SICONOS_IPARAM_MAX_ITER] = 20000
    options.dparam[numerics.SICONOS_DPARAM_TOL] = tolerance
    u, v = np.zeros(M.shape[0]), np.zeros(M.shape[0])
    impulse = np.zeros(rows.size)
    drift = np.zeros(rows.size)
    drift[1::3] = -SPEED  # of the block against the floor
    history = []
    for step in range(WINDOWS[-1][1]):
        f = load * (theta * ramp((step + 1) * STEP)
                    + (1 - theta) * ramp(step * STEP))
        v_free = v + STEP * factor.solve(f - C @ v - K @ (u + theta * STEP * v))
        gap = (H.T @ (u + STEP / 2 * v))[0::3]
        near = np.flatnonzero(gap <= 1e-15)
        part = (3 * near[:, None] + np.arange(3)).ravel()
        problem = numerics.FrictionContactProblem(
            3, len(near), W[np.ix_(part, part)], (H.T @ v_free + drift)[part],
            np.full(len(near), MU))
        found, velocity = impulse[part].copy(), np.zeros(part.size)
        numerics.fc3d_nsgs(problem, found, velocity, options)
        impulse[:] = 0
        impulse[part] = found
        v_new = v_free + factor.solve(H @ impulse)
        u += STEP * ((1 - theta) * v + theta * v_new)
        v = v_new
        forces = impulse.reshape(-1, 3) / STEP
        closed = (forces[:, 0] > 1e-6 * FORCE / len(contact)).sum()
        history.append((closed, forces[:, 0].sum(), -forces[:, 1].sum()))
    return np.array(history)


def main():
    print("theta, beta/s, window/ms: closed nodes, their mean, "
          "tangential over normal force, of their means")
    for theta, beta in ((1, 0), (0.75, 0), (0.51, 0), (0.5, 0), (0.5, 1e-8),
                        (0.5, 1e-7)):
        history = run(theta, beta)
        for first, last in WINDOWS:
            closed, normal, tangential = history[first:last].T
            ratio = np.abs(tangential / normal)
            print(f"{theta}, {beta:g}, {1e3 * first * STEP:g} to "
                  f"{1e3 * last * STEP:g}: {closed.min():.0f} to "
                  f"{closed.max():.0f}, {closed.mean():.1f}, {ratio.min():.5f} "
                  f"to {ratio.max():.5f}, "
                  f"{abs(tangential.sum() / normal.sum()):.5f}", flush=True)


if __name__ == "__main__":
    main()
