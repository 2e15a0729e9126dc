#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""CPU time and memory of squeal's certified eigenvalue analysis beside SLEPc's
and SciPy's on the very same matrices. README.md says what is compared.

usage: /usr/bin/python3 doc/benchmarks/cea_peers.py [--reuse] [--sizes 13 50]
           [--codes slepc_kappa ...] [--time-limit S] [--memory-limit GB]
           [--neighbour]
"""
import argparse
import csv
import json
import os
import pathlib
import resource
import subprocess
import sys
import time

import kernels

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "output" / "benchmarks" / "cea"
LOWEST, HIGHEST = 900.0, 16000.0  # Hz, as in prm/benchmarks/cea.prm
TOLERANCE = 1e-8
# The codes' own tolerances, tried in this order; looser ones than the first
# were never enough on the quadratic problem.
OWN_TOLERANCES = (1e-8, 1e-10, 1e-12, 1e-14)
FIRST_TOLERANCE = {"slepc_toar": 1e-10, "scipy_linear": 1e-12}

CODES = {
    "slepc_toar": "SLEPc PEP TOAR, complex shift, MUMPS",
    "slepc_kappa": "SLEPc Krylov-Schur, K x = kappa M x, MUMPS",
    "scipy_linear": "SciPy eigs, linearised, complex shift, SuperLU",
    "scipy_kappa": "SciPy eigs, K x = kappa M x, SuperLU",
    "pardiso_kappa": "SciPy eigs, K x = kappa M x, MKL PARDISO (pypardiso)",
}


# ---------------------------------------------------------------- matrices


def read_matrix_market(path):
    """The same as scipy.io.mmread, but fast for real coordinate files."""
    import numpy as np
    import scipy.io
    import scipy.sparse as sp

    with open(path) as file:
        words = file.readline().split()
        if words[2:4] != ["coordinate", "real"]:
            return scipy.io.mmread(path)
        line = file.readline()
        while line.startswith("%"):
            line = file.readline()
        n_rows, n_columns, n_entries = map(int, line.split())
        entries = np.fromfile(file, sep=" ").reshape(n_entries, 3)
    rows, columns = entries[:, :2].T.astype(np.int32) - 1
    matrix = sp.csr_matrix(
        (entries[:, 2], (rows, columns)), shape=(n_rows, n_columns))
    if words[4] == "symmetric":
        matrix = matrix + sp.tril(matrix, -1).T.tocsr()
    return matrix


def relative_residuals(M, C, K, values, vectors):
    """||Q x|| / (|lambda|^2 ||M x|| + |lambda| ||C x|| + ||K x||) of each
    pair, Q = lambda^2 M + lambda C + K."""
    import numpy as np

    norm = lambda X: np.linalg.norm(X, axis=0)
    Mx, Cx, Kx = M @ vectors, C @ vectors, K @ vectors
    size = np.abs(values)
    return norm(values**2 * Mx + values * Cx + Kx) / (
        size**2 * norm(Mx) + size * norm(Cx) + norm(Kx))


def load(folder):
    """M, C, K as CSR; kept beside the text as a binary copy."""
    import scipy.sparse as sp

    matrices = []
    for name in ("mass", "damping", "stiffness"):
        text, binary = folder / f"{name}.mtx", folder / f"{name}.npz"
        if not binary.exists() or binary.stat().st_mtime < text.stat().st_mtime:
            sp.save_npz(binary, read_matrix_market(text), compressed=False)
        matrices.append(sp.load_npz(binary))
    return matrices


def rayleigh_coefficients(M, C, K):
    """alpha, beta of C = alpha M + beta K; None where C is not such a sum."""
    import numpy as np

    x = np.random.default_rng(1).standard_normal(M.shape[0])
    basis, target = np.stack([M @ x, K @ x], axis=1), C @ x
    scale = np.linalg.norm(basis, axis=0)
    coefficients = np.linalg.lstsq(basis / scale, target, rcond=None)[0] / scale
    error = np.linalg.norm(basis @ coefficients - target)
    return coefficients if error <= 1e-10 * np.linalg.norm(target) else None


def lambda_of_kappa(kappa, alpha, beta):
    """Root with positive imaginary part of lambda^2 + (alpha + beta kappa)
    lambda + kappa = 0."""
    import numpy as np

    half = 0.5 * (alpha + beta * kappa)
    root = np.sqrt((kappa - half**2).astype(complex))
    root = np.where(root.real < 0, -root, root)
    return -half + 1j * root


def omega(frequency):
    return 2 * 3.141592653589793 * frequency


# ------------------------------------------------------------------- peers
# Each takes M, C, K and the number of pairs and returns lambda and vectors.
# The shift is the middle of the band, in lambda or in lambda^2, so that the
# pairs nearest to it are those of the band.

KAPPA_SHIFT = 0.5 * (omega(LOWEST)**2 + omega(HIGHEST)**2)
LAMBDA_SHIFT = 0.5j * (omega(LOWEST) + omega(HIGHEST))


def use_mumps(spectral_transformation):
    ksp = spectral_transformation.getKSP()
    ksp.setType("preonly")
    ksp.getPC().setType("lu")
    ksp.getPC().setFactorSolverType("mumps")


def petsc_matrix(PETSc, A):
    return PETSc.Mat().createAIJ(
        A.shape, csr=(A.indptr, A.indices, A.data), comm=PETSc.COMM_SELF)


def petsc(arguments):
    import slepc4py

    slepc4py.init(["slepc"] + arguments)
    from petsc4py import PETSc
    from slepc4py import SLEPc

    return PETSc, SLEPc


def solve_slepc_toar(M, C, K, n_pairs, tolerance):
    import numpy as np

    # METIS, as squeal; MUMPS' own choice was no faster.
    PETSc, SLEPc = petsc(["-st_mat_mumps_icntl_7", "5"])
    pep = SLEPc.PEP().create(PETSc.COMM_SELF)
    pep.setOperators([petsc_matrix(PETSc, A) for A in (K, C, M)])
    pep.setType(SLEPc.PEP.Type.TOAR)
    # The automatic factor is for the largest eigenvalues of the mesh.
    pep.setScale(SLEPc.PEP.Scale.SCALAR, abs(LAMBDA_SHIFT))
    pep.setDimensions(n_pairs)
    pep.setTolerances(tolerance, 500)
    pep.setTarget(LAMBDA_SHIFT)
    pep.setWhichEigenpairs(SLEPc.PEP.Which.TARGET_MAGNITUDE)
    pep.getST().setType(SLEPc.ST.Type.SINVERT)
    use_mumps(pep.getST())
    pep.setFromOptions()
    pep.solve()
    n = min(pep.getConverged(), n_pairs)
    values, vectors = np.zeros(n, complex), np.zeros((M.shape[0], n), complex)
    x = PETSc.Vec().createSeq(M.shape[0])
    for i in range(n):
        values[i] = pep.getEigenpair(i, x)
        vectors[:, i] = x.getArray()
    pep.destroy()
    return values, vectors


def solve_slepc_kappa(M, C, K, n_pairs, tolerance):
    import numpy as np

    PETSc, SLEPc = petsc(["-st_mat_mumps_icntl_7", "5"])
    eps = SLEPc.EPS().create(PETSc.COMM_SELF)
    eps.setOperators(petsc_matrix(PETSc, K), petsc_matrix(PETSc, M))
    eps.setProblemType(SLEPc.EPS.ProblemType.PGNHEP)
    eps.setType(SLEPc.EPS.Type.KRYLOVSCHUR)
    eps.setDimensions(n_pairs)
    eps.setTolerances(tolerance, 500)
    eps.setTarget(KAPPA_SHIFT)
    eps.setWhichEigenpairs(SLEPc.EPS.Which.TARGET_MAGNITUDE)
    eps.getST().setType(SLEPc.ST.Type.SINVERT)
    use_mumps(eps.getST())
    eps.setFromOptions()
    eps.solve()
    n = min(eps.getConverged(), n_pairs)
    kappa, vectors = np.zeros(n, complex), np.zeros((M.shape[0], n), complex)
    re, im = (PETSc.Vec().createSeq(M.shape[0]) for _ in range(2))
    for i in range(n):
        kappa[i] = eps.getEigenpair(i, re, im)
        vectors[:, i] = re.getArray() + 1j * im.getArray()
    eps.destroy()
    return lambda_of_kappa(kappa, *rayleigh_coefficients(M, C, K)), vectors


def superlu(A):
    import scipy.sparse.linalg as sl

    # For a matrix of symmetric pattern; the default ordering fills in more.
    return sl.splu(
        A.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.01,
        options={"SymmetricMode": True}).solve


def pardiso(A):
    import ctypes

    import numpy as np
    import pypardiso

    A = A.tocsr()
    A.sort_indices()
    solver = pypardiso.PyPardisoSolver()
    # Serial METIS, no matching, pivots perturbed at 1e-20 only: with the
    # defaults every solution is refined twice, to the same residual.
    for number, value in ((1, 1), (2, 2), (10, 20)):
        solver.set_iparm(number, value)
    solver.set_phase(12)
    solver._call_pardiso(A, np.zeros((A.shape[0], 1)))
    # pypardiso's own call makes new copies of the indices for each solution.
    starts = (A.indptr + 1).astype(np.int32)
    columns = (A.indices + 1).astype(np.int32)
    integers = ctypes.POINTER(ctypes.c_int32)
    doubles = ctypes.POINTER(ctypes.c_double)
    number = lambda i: ctypes.byref(ctypes.c_int32(i))

    def solve(b):
        x, error = np.empty_like(b), ctypes.c_int32(0)
        solver._mkl_pardiso(
            solver.pt.ctypes.data_as(ctypes.POINTER(ctypes.c_int64)),
            number(1), number(1), number(11), number(33), number(len(b)),
            A.data.ctypes.data_as(doubles), starts.ctypes.data_as(integers),
            columns.ctypes.data_as(integers),
            solver.perm.ctypes.data_as(integers), number(1),
            solver.iparm.ctypes.data_as(integers), number(0),
            b.ctypes.data_as(doubles), x.ctypes.data_as(doubles),
            ctypes.byref(error))
        if error.value != 0:
            raise RuntimeError(f"PARDISO error {error.value}")
        return x

    return solve


def arnoldi(apply, n, n_pairs, dtype, tolerance):
    import numpy as np
    import scipy.sparse.linalg as sl

    start = np.random.default_rng(1).standard_normal(n).astype(dtype)
    return sl.eigs(
        sl.LinearOperator((n, n), apply, dtype=dtype), k=n_pairs, which="LM",
        ncv=2 * n_pairs + 20, tol=tolerance, v0=start)


def solve_scipy_linear(M, C, K, n_pairs, tolerance):
    """The pencil of (x, mu x), lambda = unit mu, of which only Q(shift) needs
    a factor; in that unit the two halves are of one size."""
    import numpy as np

    n, unit = M.shape[0], abs(LAMBDA_SHIFT)
    M, C, s = unit**2 * M, unit * C, LAMBDA_SHIFT / unit
    solve = superlu(s**2 * M + s * C + K)

    def apply(z):
        x = solve(-(M @ (z[n:] + s * z[:n]) + C @ z[:n]))
        return np.concatenate([x, z[:n] + s * x])

    theta, vectors = arnoldi(apply, 2 * n, n_pairs, complex, tolerance)
    return unit * (s + 1 / theta), vectors[:n]


def solve_kappa(M, C, K, n_pairs, tolerance, factorize):
    solve = factorize(K - KAPPA_SHIFT * M)
    theta, vectors = arnoldi(
        lambda x: solve(M @ x), M.shape[0], n_pairs, float, tolerance)
    kappa = KAPPA_SHIFT + 1 / theta
    return lambda_of_kappa(kappa, *rayleigh_coefficients(M, C, K)), vectors


def solve_scipy_kappa(*arguments):
    return solve_kappa(*arguments, superlu)


def solve_pardiso_kappa(*arguments):
    return solve_kappa(*arguments, pardiso)


# ------------------------------------------------------------ measurement


def reset_peak_memory():
    """Peak memory counts from here on (reading text files needs more than
    solving small problems)."""
    with open("/proc/self/clear_refs", "w") as file:
        file.write("5")


def peak_memory_mb():
    with open("/proc/self/status") as file:
        for line in file:
            if line.startswith("VmHWM:"):
                return float(line.split()[1]) * 1024e-6


def largest_difference(reference, values):
    """Largest |lambda - nearest| / |lambda| over the reference."""
    import numpy as np

    distance = np.abs(reference[:, None] - values[None, :]).min(axis=1)
    return float((distance / np.abs(reference)).max())


def measure(code, folder, time_limit, memory_limit):
    """Runs one code in this process and prints the result as JSON."""
    import scipy.io

    M, C, K = load(folder)
    reference = scipy.io.mmread(folder / "eigenvalues.mtx").ravel()
    used = int(time.process_time())
    resource.setrlimit(
        resource.RLIMIT_CPU, (used + time_limit, used + time_limit + 10))
    resource.setrlimit(
        resource.RLIMIT_AS, (int(memory_limit * 1e9),) * 2)
    reset_peak_memory()
    # The codes' own criteria are about the transformed problem: the loosest
    # tolerance with which all residuals of the problem itself are small.
    for tolerance in OWN_TOLERANCES:
        if tolerance > FIRST_TOLERANCE.get(code, tolerance):
            continue
        start = time.process_time()
        values, vectors = globals()["solve_" + code](
            M, C, K, len(reference), tolerance)
        residual = float(relative_residuals(M, C, K, values, vectors).max())
        seconds = time.process_time() - start
        if residual <= TOLERANCE:
            break
    print(json.dumps({
        "cpu_seconds": seconds, "peak_memory_mb": peak_memory_mb(),
        "pairs": len(values), "worst_residual": residual,
        "difference_to_squeal": largest_difference(reference, values),
        "note": f"own tolerance {tolerance:g}"}))


def environment(code):
    """One thread everywhere; PETSc with the scalars that the code needs."""
    result = dict(os.environ)
    for name in ("OMP", "OPENBLAS", "MKL"):
        result[name + "_NUM_THREADS"] = "1"
    kernels.take_those_of_squeal(result)
    result["OMPI_ALLOW_RUN_AS_ROOT"] = "1"
    result["OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"] = "1"
    if code.startswith("slepc"):
        kind = "complex" if code == "slepc_toar" else "real"
        paths = [
            path for library in ("slepc", "petsc")
            for path in pathlib.Path("/usr/lib", library + "dir").glob(
                f"{library}*/*-{kind}/lib/python3/dist-packages")]
        result["PYTHONPATH"] = ":".join(map(str, paths))
    return result


def run_peer(code, folder, options):
    python = ROOT / "build" / "peers" / "bin" / "python"
    if code != "pardiso_kappa" or not python.exists():
        python = sys.executable
    done = subprocess.run(
        [python, __file__, "--measure", code, str(folder),
         "--time-limit", str(options.time_limit),
         "--memory-limit", str(options.memory_limit)],
        env=environment(code), capture_output=True, text=True)
    if done.returncode == 0:
        return json.loads(done.stdout.splitlines()[-1])
    if done.returncode in (-24, -9):  # SIGXCPU, SIGKILL
        return {"note": f"not done after {options.time_limit} CPU s"}
    if done.returncode < 0:
        return {"note": f"ended by signal {-done.returncode}"}
    lines = done.stderr.strip().splitlines() or ["without a word"]
    return {"note": "failed: " + lines[-1][:80]}


def squeal_row(rung, folder):
    """Time and memory as squeal wrote them, residuals as everybody's."""
    import scipy.io

    values = scipy.io.mmread(folder / "eigenvalues.mtx").ravel()
    vectors = scipy.io.mmread(folder / "right_vectors.mtx")
    return {
        "code": "squeal certified", "dofs": int(rung["dofs"]),
        "cpu_seconds": sum(float(rung[stage + "_cpu_s"])
                           for stage in ("factor", "modes", "pairs")),
        "peak_memory_mb": float(rung["peak_memory_mb"]),
        "pairs": len(values),
        "worst_residual": float(
            relative_residuals(*load(folder), values, vectors).max()),
        "difference_to_squeal": 0.0, "ratio": 1.0,
        "note": "memory with mesh and assembly"}


COLUMNS = {
    "code": "{}", "dofs": "{}", "cpu_seconds": "{:.1f}",
    "peak_memory_mb": "{:.0f}", "pairs": "{}", "worst_residual": "{:.1e}",
    "difference_to_squeal": "{:.1e}", "ratio": "{:.2f}", "note": "{}"}


def print_table(rows):
    cells = [list(COLUMNS)] + [
        [format.format(row[name]) if name in row else ""
         for name, format in COLUMNS.items()] for row in rows]
    widths = [max(map(len, column)) for column in zip(*cells)]
    for line in cells:
        print("  ".join(cell.ljust(w) for cell, w in zip(line, widths)).rstrip())


def compare(options):
    if not options.reuse:
        subprocess.run(
            [ROOT / "squeal", "run", "prm/benchmarks/cea.prm"], cwd=ROOT,
            check=True)
    with open(FOLDER / "work_precision.csv") as file:
        rungs = sorted(csv.DictReader(file), key=lambda r: int(r["dofs"]))
    rows, out_of_reach = [], set()
    for rung in rungs:
        if options.sizes and int(rung["dofs"]) // 1000 not in options.sizes:
            continue
        folder = FOLDER / rung["matrices"]
        rows.append(squeal_row(rung, folder))
        squeal_seconds = rows[-1]["cpu_seconds"]
        for code in options.codes:
            row = {"code": CODES[code], "dofs": int(rung["dofs"])}
            if code in out_of_reach:
                row["note"] = "left out: a smaller size was not done"
            else:
                row.update(run_peer(code, folder, options))
                if "cpu_seconds" in row:
                    row["ratio"] = row["cpu_seconds"] / squeal_seconds
                else:
                    out_of_reach.add(code)
            rows.append(row)
            print(row["code"], row["dofs"], row["note"], file=sys.stderr)
    print_table(rows)
    path = FOLDER.parent / "cea_peers.csv"
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, list(COLUMNS))
        writer.writeheader()
        writer.writerows(rows)
    print(f"written to {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--reuse", action="store_true",
                        help="take the matrices of an earlier run")
    parser.add_argument("--sizes", type=int, nargs="+", metavar="K",
                        help="only these sizes, in thousands of unknowns")
    parser.add_argument("--codes", nargs="+", choices=list(CODES),
                        default=list(CODES))
    parser.add_argument("--time-limit", type=int, default=900,
                        help="CPU seconds for one code and size (900)")
    parser.add_argument("--memory-limit", type=float, default=16.,
                        help="address space of one code in GB (16)")
    parser.add_argument("--neighbour", action="store_true",
                        help="all beside a stream benchmark on another core")
    parser.add_argument("--measure", nargs=2, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.measure:
        measure(options.measure[0], pathlib.Path(options.measure[1]),
                options.time_limit, options.memory_limit)
    elif options.neighbour:
        if options.reuse:
            parser.error("--reuse takes squeal's times of another run")
        with subprocess.Popen([sys.executable,
                               pathlib.Path(__file__).with_name("neighbour.py")]) as busy:
            try:
                compare(options)
            finally:
                busy.terminate()
    else:
        compare(options)


if __name__ == "__main__":
    main()
