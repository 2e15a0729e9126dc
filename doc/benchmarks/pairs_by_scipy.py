#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Complex eigenvalues nearest to a frequency by SciPy alone, from the matrices
that squeal exports ('Output/Export matrices = true'):

    pairs_by_scipy.py output/ventilated_brake/cea/matrices 6305 --number 6

SuperLU factorises Q(s) = s^2 M + s C + K at s = 2 pi i f (ordering of A + A^T,
pivots on the diagonal), ARPACK iterates on the linearisation z = (x, lambda x):
one step solves Q(s) x = -(M v + (C + s M) u). Needs numpy and scipy.
"""
import argparse
import pathlib
import time

import numpy
import scipy.io
import scipy.sparse
import scipy.sparse.linalg


def read(folder, name):
    return scipy.sparse.csc_matrix(scipy.io.mmread(folder / f"{name}.mtx"))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("frequency", type=float, help="Hz")
    parser.add_argument("--number", type=int, default=6)
    options = parser.parse_args()
    start = time.process_time()
    m, c, k = (read(options.folder, name) 
               for name in ("mass", "damping", "stiffness"))
    n = m.shape[0]
    shift = 2j * numpy.pi * options.frequency
    factor = scipy.sparse.linalg.splu(
        (shift ** 2 * m + shift * c + k).tocsc(), permc_spec="MMD_AT_PLUS_A",
        diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    print(f"{n} unknowns, factor of {factor.L.nnz + factor.U.nnz} entries, "
          f"{time.process_time() - start:.0f} CPU s", flush=True)

    def inverse(z):
        u, v = z[:n], z[n:]
        x = -factor.solve(m @ v + c @ u + shift * (m @ u))
        return numpy.concatenate([x, u + shift * x])

    values, vectors = scipy.sparse.linalg.eigs(
        scipy.sparse.linalg.LinearOperator((2 * n, 2 * n), inverse, dtype=complex),
        k=options.number, tol=1e-10)
    for mu, z in zip(values, vectors.T):
        lam, x = shift + 1 / mu, z[:n]
        residual = numpy.linalg.norm(lam ** 2 * (m @ x) + lam * (c @ x) + k @ x)
        scale = numpy.linalg.norm(k @ x)
        print(f"{lam.imag / 2 / numpy.pi:.9f} Hz  sigma {lam.real:.9f} 1/s  "
              f"residual {residual / scale:.1e}")
    print(f"{time.process_time() - start:.0f} CPU s")


if __name__ == "__main__":
    main()
