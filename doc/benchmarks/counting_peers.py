# SPDX-License-Identifier: LGPL-2.1-or-later
"""Rainflow counting with damage beside pyLife, on the same noise.

    python3 -m venv /tmp/peers && /tmp/peers/bin/pip install pylife
    /tmp/peers/bin/python doc/benchmarks/counting_peers.py

121 nodes with 1e6 samples of white noise each, damage of the slopes 3, 5, 10.
squeal is timed by its own test program, pyLife (whichever version is installed)
by its four-point counter with a recorder of the loops, and the same three power
sums in NumPy, on a few nodes, times 121. CPU seconds of one core.
"""
import argparse
import importlib.metadata
import os
import pathlib
import subprocess
import time

for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(name, "1")

import numpy as np
import pylife.stress.rainflow as rainflow

ROOT = pathlib.Path(__file__).resolve().parents[2]


def pylife_seconds(n_nodes, n_samples):
    generator = np.random.default_rng(1)
    seconds = 0.0
    for _ in range(n_nodes):
        signal = generator.standard_normal(n_samples)
        start = time.process_time()
        recorder = rainflow.LoopValueRecorder()
        counter = rainflow.FourPointDetector(recorder=recorder)
        counter.process(signal)
        amplitude = 0.5 * np.abs(recorder.values_to - recorder.values_from)
        residue = 0.5 * np.abs(np.diff(counter.residuals))
        damage = [np.sum(amplitude**m) + 0.5 * np.sum(residue**m)
                  for m in (3, 5, 10)]
        seconds += time.process_time() - start
        assert np.all(np.isfinite(damage))
    return seconds / n_nodes


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--nodes", type=int, default=5,
                        help="nodes that pyLife counts")
    parser.add_argument("--build", default=str(ROOT / "build"))
    options = parser.parse_args()

    program = pathlib.Path(options.build,
                           "tests/programs/test_tribology_counting_speed")
    text = subprocess.run([program, "1e9"], check=True, text=True,
                          capture_output=True).stdout
    squeal = float(next(line for line in text.splitlines()
                        if " CPU s, " in line).split()[0])
    version = importlib.metadata.version("pylife")
    peer = 121 * pylife_seconds(options.nodes, 1000000)
    print("| code | 121 x 1e6 samples, CPU s | ratio |")
    print("| --- | --- | --- |")
    print(f"| squeal | {squeal:.2f} | 1 |")
    print(f"| pyLife {version} (from {options.nodes} nodes) | {peer:.2f} | "
          f"{peer / squeal:.1f} |")


if __name__ == "__main__":
    main()
