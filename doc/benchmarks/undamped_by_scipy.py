#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Eigenvalues of an undamped model with friction by SciPy, from the matrices
that squeal exported, beside squeal's own.

    ./squeal run --set 'Discretization/Degree = 2' \\
      --set 'Output/Export matrices = true' prm/ventilated_brake/cea.prm
    /usr/bin/python3 doc/benchmarks/undamped_by_scipy.py \\
      output/ventilated_brake/cea/matrices

K x = kappa M x with kappa = -lambda^2, K and M not symmetric: ARPACK on the
inverse of K - s M (SuperLU), nothing of squeal's reduction to a basis. Prints the
largest relative distance of an eigenvalue of squeal's to the nearest one here.
"""
import pathlib
import sys

import numpy
import scipy.io
import scipy.sparse.linalg

folder = pathlib.Path(sys.argv[1])
M, C, K = (scipy.io.mmread(folder / (name + ".mtx")).tocsc()
           for name in ("mass", "damping", "stiffness"))
squeal = scipy.io.mmread(folder / "eigenvalues.mtx").ravel()
if C.nnz and abs(C).max() > 0:
    sys.exit("the model is damped: use cea_peers.py")

low, high = squeal.imag.min() ** 2, squeal.imag.max() ** 2
shift = (low + high) / 2
factor = scipy.sparse.linalg.splu(K - shift * M)
inverse = scipy.sparse.linalg.LinearOperator(
    K.shape, matvec=lambda x: factor.solve(M @ x), dtype=float)
# both eigenvalues of a pair that friction has split are among squeal's
nu = scipy.sparse.linalg.eigs(inverse, k=len(squeal) + 10, tol=1e-12,
                              return_eigenvectors=False)
root = numpy.sqrt(-(shift + 1 / nu).astype(complex))
here = numpy.concatenate([root, -root])

distance = numpy.array([abs(here - value).min() for value in squeal])
for value in squeal[squeal.real > 1e-6 * abs(squeal)]:
    other = here[abs(here - value).argmin()]
    print(f"unstable: {value.imag / 2 / numpy.pi:.4f} Hz, "
          f"{value.real:.4f} 1/s; SciPy {other.imag / 2 / numpy.pi:.4f} Hz, "
          f"{other.real:.4f} 1/s")
print(f"{K.shape[0]} unknowns, {len(squeal)} eigenvalues, largest relative "
      f"distance {(distance / abs(squeal)).max():.2e}")
