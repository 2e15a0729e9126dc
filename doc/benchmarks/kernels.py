# SPDX-License-Identifier: LGPL-2.1-or-later
"""The kernels of OpenBLAS that squeal works with, for its peers."""
import os
import pathlib
import subprocess

PROGRAM = pathlib.Path(__file__).resolve().parents[2] / "build" / "squeal"


def take_those_of_squeal(environment=os.environ):
    """Sets OPENBLAS_CORETYPE as squeal does, unless the user has set it. To be
    called before OpenBLAS is loaded."""
    text = subprocess.run([PROGRAM, "--version"], check=True,
                          capture_output=True, text=True).stdout
    title = "OpenBLAS kernels "
    names = [line.strip()[len(title):] for line in text.splitlines()
             if line.strip().startswith(title)]
    environment.setdefault("OPENBLAS_CORETYPE", names[0])
