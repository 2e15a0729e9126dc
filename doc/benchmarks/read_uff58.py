#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads the universal files of a frequency response run with pyuff and compares
every value with the CSV and, where h5py is there, with the HDF5 file.

usage: read_uff58.py OUTPUT_DIRECTORY
"""
import csv
import glob
import os
import sys

import numpy
import pyuff

TOLERANCE = 1e-11  # dataset 58 has twelve digits


def functions_of(path):
    """Responses of a universal file by (excitation, response)."""
    file = pyuff.UFF(path)
    found = {}
    for number, kind in enumerate(file.get_set_types()):
        data = file.read_sets(number)
        if kind != 58:
            continue
        assert data["func_type"] == 4, "a frequency response"
        assert data["abscissa_spec_data_type"] == 18, "over frequency"
        assert data["orddenom_spec_data_type"] == 13, "over force"
        key = (data["ref_ent_name"].strip(), data["rsp_ent_name"].strip())
        found[key] = (numpy.asarray(data["x"]), numpy.asarray(data["data"]), data)
    return found


def table_of(path):
    """The same from frequency_response.csv, by contact state; names are cut to
    ten characters as in universal files."""
    found = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            key = (row["excitation"][:10], row["response"][:10])
            state = found.setdefault(row["contact_state"], {})
            value = complex(float(row["real"]), float(row["imag"]))
            state.setdefault(key, []).append((float(row["frequency_hz"]), value))
    return found


def compare_hdf5(directory, state, functions):
    try:
        import h5py
    except ImportError:
        return None
    worst = 0.0
    with h5py.File(os.path.join(directory, "frequency_response.h5"), "r") as file:
        names = [
            [name.decode()[:10] for name in file[group + "/name"]]
            for group in ("excitations", "responses")
        ]
        values = file[state + "/real"][()] + 1j * file[state + "/imag"][()]
        for j, excitation in enumerate(names[0]):
            for i, response in enumerate(names[1]):
                data = functions[(excitation, response)][1]
                worst = max(worst, difference(data, values[j, i]))
    return worst


def difference(a, b):
    return float(numpy.max(numpy.abs(a - b)) / numpy.max(numpy.abs(b)))


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    directory = sys.argv[1]
    table = table_of(os.path.join(directory, "frequency_response.csv"))
    worst = 0.0
    for state, expected in table.items():
        path = os.path.join(directory, f"frequency_response_{state}.uff")
        functions = functions_of(path)
        if set(functions) != set(expected):
            sys.exit(f"{path}: points {set(functions)}, not {set(expected)}")
        for key, rows in expected.items():
            x, y, _ = functions[key]
            worst = max(
                worst,
                difference(x, numpy.array([row[0] for row in rows])),
                difference(y, numpy.array([row[1] for row in rows])),
            )
        with_hdf5 = compare_hdf5(directory, state, functions)
        print(
            f"{state}: {len(functions)} functions of {len(x)} frequencies; largest "
            f"relative difference to the CSV so far {worst:.1e}"
            + ("" if with_hdf5 is None else f", to the HDF5 {with_hdf5:.1e}")
        )
        worst = max(worst, with_hdf5 or 0.0)
    if not glob.glob(os.path.join(directory, "*.uff")) or not worst <= TOLERANCE:
        sys.exit(f"FAILED: {worst:.1e} exceeds {TOLERANCE:.0e}")


if __name__ == "__main__":
    main()
