#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A busy neighbour: the triad of the STREAM benchmark, a = b + s c over arrays
beyond every cache, on one core until it is stopped. Figures of codes beside it
show how they fare where the memory is shared.

usage: neighbour.py          (ends with SIGTERM or after an hour)
"""
import os
import time

os.environ["OPENBLAS_NUM_THREADS"] = "1"

import numpy as np  # noqa: E402

LENGTH = 20_000_000  # 160 MB an array


def main():
    a, b, c = (np.full(LENGTH, value) for value in (0.0, 1.0, 2.0))
    end = time.monotonic() + 3600
    while time.monotonic() < end:
        np.multiply(c, 3.0, out=a)
        np.add(a, b, out=a)


if __name__ == "__main__":
    main()
