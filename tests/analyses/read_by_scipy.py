#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""scipy.io.mmread reads every exported file, and the exported pairs solve the
exported problem by the residual of doc/benchmarks/cea_peers.py.

usage: read_by_scipy.py MATRICES CEA_PEERS_DIRECTORY
"""
import pathlib
import sys

import scipy.io

folder = pathlib.Path(sys.argv[1])
sys.path.insert(0, sys.argv[2])
import cea_peers  # noqa: E402

read = {path.stem: scipy.io.mmread(path) for path in folder.glob("*.mtx")}
assert len(read) > 10, f"{len(read)} files in {folder}"
M, C, K = (read[name].tocsr() for name in ("mass", "damping", "stiffness"))
assert M.shape == C.shape == K.shape and M.nnz > 0
assert abs(M - M.T).max() == 0 and abs(K - K.T).max() > 0
for name, matrix in (("mass", M), ("stiffness", K)):
    other = cea_peers.read_matrix_market(folder / (name + ".mtx"))
    assert abs(matrix - other).max() == 0, name

values, vectors = read["eigenvalues"].ravel(), read["right_vectors"]
residuals = cea_peers.relative_residuals(M, C, K, values, vectors)
assert len(values) > 5 and residuals.max() <= 1e-8, residuals
assert cea_peers.relative_residuals(
    M, C, K, values * (1 + 1e-4), vectors).min() > 1e-6

alpha, beta = cea_peers.rayleigh_coefficients(M, C, K)
assert abs(alpha - 0.02) < 1e-4 and abs(beta - 1e-7) < 1e-13, (alpha, beta)
kappa = -(values**2 + alpha * values) / (1 + beta * values)
back = cea_peers.lambda_of_kappa(kappa, alpha, beta)
assert abs(back / values - 1).max() < 1e-12
print("ok", len(values), "pairs, worst residual", residuals.max())
