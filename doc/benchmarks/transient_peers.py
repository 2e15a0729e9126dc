#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Steps per second of squeal's implicit integrator beside Siconos' on the block of
prm/benchmarks/block_on_floor.prm: 10 x 10 x 10 trilinear hexahedra, 121 contact
nodes, dt = 1 us, and squeal's explicit integrator beside the machine's memory.
README.md says what is compared.

usage: /usr/bin/python3 doc/benchmarks/transient_peers.py [--steps N] [--no-siconos]
"""
import argparse
import csv
import json
import os
import pathlib
import subprocess
import time

import kernels

kernels.take_those_of_squeal()
for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ[name] = "1"

import numpy as np  # noqa: E402
import scipy.sparse as sp  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
OUTPUT = ROOT / "output" / "benchmarks"
SIDE, CELLS, YOUNG, NU, RHO = 0.01, 10, 16e9, 0.3, 2500.0
FORCE, SPEED, MU, BETA, STEP = 100.0, 0.12, 0.3, 1e-7, 1e-6


# ------------------------------------------------------------------- the block


def element_matrices(h):
    """Stiffness and mass of a cube of side h, eight nodes, x fastest."""
    G = YOUNG / (2 * (1 + NU))
    lame = YOUNG * NU / ((1 + NU) * (1 - 2 * NU))
    D = np.diag([2 * G] * 3 + [G] * 3)
    D[:3, :3] += lame
    K, M = np.zeros((24, 24)), np.zeros((24, 24))
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)])
    g = 0.5 + np.array([-1, 1]) / np.sqrt(12)
    for point in ((a, b, c) for a in g for b in g for c in g):
        one = np.where(corners == 1, point, 1 - np.array(point))
        sign = np.where(corners == 1, 1.0, -1.0)
        N = one.prod(axis=1)
        dN = np.stack([sign[:, c] * np.delete(one, c, 1).prod(axis=1) / h
                       for c in range(3)])
        B = np.zeros((6, 24))
        for c in range(3):
            B[c, c::3] = dN[c]
        B[3, 0::3], B[3, 1::3] = dN[1], dN[0]
        B[4, 1::3], B[4, 2::3] = dN[2], dN[1]
        B[5, 0::3], B[5, 2::3] = dN[2], dN[0]
        K += B.T @ D @ B * h**3 / 8
        M += RHO * np.kron(np.outer(N, N), np.eye(3)) * h**3 / 8
    return K, M


def block():
    """M, K, load and the displacements of the 121 nodes on the floor: normal
    (z), along (y) and across (x), of the free unknowns."""
    n, h = CELLS + 1, SIDE / CELLS
    number = np.arange(n**3).reshape(n, n, n)  # z, y, x
    Ke, Me = element_matrices(h)
    rows, cols, k, m = [], [], [], []
    for z in range(CELLS):
        for y in range(CELLS):
            for x in range(CELLS):
                nodes = number[z:z + 2, y:y + 2, x:x + 2].ravel()
                dofs = (3 * nodes[:, None] + np.arange(3)).ravel()
                rows.append(np.repeat(dofs, 24))
                cols.append(np.tile(dofs, 24))
                k.append(Ke.ravel())
                m.append(Me.ravel())
    shape = (3 * n**3,) * 2
    build = lambda v: sp.csr_matrix(  # noqa: E731
        (np.concatenate(v), (np.concatenate(rows), np.concatenate(cols))), shape)
    K, M = build(k), build(m)
    top = number[-1].ravel()
    free = np.setdiff1d(np.arange(3 * n**3),
                        np.concatenate([3 * top, 3 * top + 1]))
    weight = np.outer(*[np.r_[0.5, np.ones(n - 2), 0.5]] * 2).ravel()
    load = np.zeros(3 * n**3)
    load[3 * top + 2] = -FORCE * weight / weight.sum()
    floor = number[0].ravel()
    place = np.full(3 * n**3, -1)
    place[free] = np.arange(len(free))
    contact = place[np.stack([3 * floor + 2, 3 * floor + 1, 3 * floor], axis=1)]
    cut = lambda A: A[free][:, free].tocsr()  # noqa: E731
    return cut(M), cut(K), load[free], contact


def ramp(t):
    return min(1.0, t / 5e-6)


# --------------------------------------------------------------------- Siconos


def law_residual(W, free_velocity, impulse, mean):
    """The residual that squeal prints: the largest difference between a nodal
    force and what the law makes of it and the velocity, over the mean force."""
    velocity = free_velocity + W @ impulse
    worst = 0.0
    for j in range(0, len(impulse), 3):
        p, v = impulse[j:j + 3], velocity[j:j + 3]
        rho = 1 / W[j, j]
        rho_t = 1 / max(W[j + 1, j + 1], W[j + 2, j + 2])
        normal = max(0.0, p[0] - rho * v[0])
        tried = p[1:] - rho_t * v[1:]
        size = np.linalg.norm(tried)
        if size > MU * normal:
            tried = tried * (MU * normal / size if size > 0 else 0)
        worst = max(worst, abs(p[0] - normal), np.abs(p[1:] - tried).max())
    return worst / mean


def run_siconos(steps, tolerance):
    import siconos.numerics as numerics
    from scipy.sparse.linalg import splu

    M, K, load, contact = block()
    C = BETA * K
    A = (M + STEP / 2 * C + STEP**2 / 4 * K).tocsc()
    begin = time.process_time()
    factor = splu(A, permc_spec="MMD_AT_PLUS_A")
    n_contacts = len(contact)
    rows = contact.ravel()
    H = sp.csc_matrix((np.ones(rows.size), (rows, np.arange(rows.size))),
                      (M.shape[0], rows.size))
    W = H.T @ factor.solve(H.toarray())
    W = 0.5 * (W + W.T)
    setup = time.process_time() - begin

    options = numerics.SolverOptions(numerics.SICONOS_FRICTION_3D_NSGS)
    options.iparam[numerics.SICONOS_IPARAM_MAX_ITER] = 100000
    options.dparam[numerics.SICONOS_DPARAM_TOL] = tolerance
    mu = np.full(n_contacts, MU)
    u, v = np.zeros(M.shape[0]), np.zeros(M.shape[0])
    impulse, velocity = np.zeros(rows.size), np.zeros(rows.size)
    drift = np.zeros(rows.size)
    drift[1::3] = -SPEED  # of the block against the floor
    mean = FORCE * STEP / n_contacts
    residuals, iterations, failed = [], 0, 0
    begin = time.process_time()
    for step in range(steps):
        f = load * ramp((step + 0.5) * STEP)
        rest = f - K @ (u + STEP / 2 * v) - C @ v
        v_free = v + STEP * factor.solve(rest)
        q = H.T @ v_free + drift
        # Contacts that are apart by the end of the step stay out of it.
        gap = H.T @ (u + STEP / 2 * v)
        problem = numerics.FrictionContactProblem(3, n_contacts, W, q.copy(), mu)
        far = gap[0::3] > 0
        problem.q[0::3][far] += gap[0::3][far] / STEP * 2
        info = numerics.fc3d_nsgs(problem, impulse, velocity, options)
        failed += info != 0
        iterations += options.iparam[numerics.SICONOS_IPARAM_ITER_DONE]
        if step % 100 == 99:
            residuals.append(law_residual(W, problem.q, impulse, mean))
        v_new = v_free + factor.solve(H @ impulse)
        u += STEP / 2 * (v + v_new)
        v = v_new
    seconds = time.process_time() - begin
    total = impulse.reshape(-1, 3).sum(axis=0) / STEP
    return {"steps_per_s": steps / seconds, "iterations": iterations / steps,
            "residual": max(residuals), "setup_s": setup, "failed": failed,
            "closed": int((impulse[0::3] > 1e-6 * mean).sum()),
            "friction": -total[1] / total[0], "unknowns": M.shape[0]}


# ---------------------------------------------------------------------- squeal


def run_squeal(steps, integrator, step, tolerance):
    folder = OUTPUT / ("block_" + integrator)
    command = [str(ROOT / "build" / "squeal"),
               str(ROOT / "prm" / "benchmarks" / "block_on_floor.prm")]
    for entry, value in {
            "Output directory": folder, "Transient/Integrator": integrator,
            "Transient/Time step": step, "Transient/End time": steps * step,
            "Transient/Tolerance": tolerance}.items():
        command += ["--set", f"{entry} = {value}"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, cwd=ROOT)
    with open(folder / "transient.csv") as file:
        row = next(csv.DictReader(file))
    run = json.loads((folder / "run.json").read_text())
    return {"steps_per_s": float(row["steps_per_second"]),
            "iterations": float(row["iterations_per_step"]),
            "friction": float(row["macroscopic_friction"]),
            "unknowns": run["dofs"]}


def memory_bandwidth():
    """Bytes per second of a triad on vectors beyond every cache share."""
    a, b, c = (np.zeros(2**25) for _ in range(3))
    best = 0.0
    for _ in range(5):
        begin = time.perf_counter()
        np.add(b, c, out=a)
        best = max(best, 3 * a.nbytes / (time.perf_counter() - begin))
    return best


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--steps", type=int, default=1000)
    parser.add_argument("--tolerance", type=float, default=1e-8)
    parser.add_argument("--no-siconos", action="store_true")
    arguments = parser.parse_args()
    ours = run_squeal(arguments.steps, "implicit", STEP, arguments.tolerance)
    print("squeal implicit", ours)
    if not arguments.no_siconos:
        for tolerance in (1e-8, 1e-10, 1e-12):
            peer = run_siconos(arguments.steps, tolerance)
            print(f"Siconos NSGS, own tolerance {tolerance:g}", peer)
            if peer["residual"] <= arguments.tolerance:
                break
        print("ratio", ours["steps_per_s"] / peer["steps_per_s"])
    print(f"memory: {memory_bandwidth() / 1e9:.1f} GB/s")


if __name__ == "__main__":
    main()
