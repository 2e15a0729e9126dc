#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes shim_rubber.csv: the complex Young's modulus of a damping polymer.

Frequency at 27 degrees Celsius: the fractional four-parameter model

    E = (E0 + Einf (i omega tau)^alpha) / (1 + (i omega tau)^alpha)

with the numbers that Galucio, Deue and Ohayon (Computational Mechanics 33, 2004,
282-291) give for the polymer ISD 112 of 3M. Temperature: the shift of time of
Williams, Landel and Ferry (J. Am. Chem. Soc. 77, 1955, 3701-3707) with its universal
constants and a glass transition at -40 degrees Celsius, which is an assumption.
"""
import math

E0, E_INF, ALPHA, TAU = 1.5e6, 69.9495e6, 0.7915, 1.4052e-5
REFERENCE, GLASS, C1, C2 = 27.0, -40.0, 17.44, 51.6


def log_shift(temperature):
    return -C1 * (temperature - GLASS) / (C2 + temperature - GLASS)


def modulus(frequency, temperature):
    a = 10.0 ** (log_shift(temperature) - log_shift(REFERENCE))
    z = (2j * math.pi * frequency * a * TAU) ** ALPHA
    return (E0 + E_INF * z) / (1.0 + z)


with open("shim_rubber.csv", "w", encoding="ascii") as out:
    out.write("# written by make_rubber.py, which gives the sources\n")
    out.write("frequency_Hz,temperature_C,storage_modulus_Pa,loss_factor\n")
    for temperature in (-20, -10, 0, 10, 20, 30, 40, 60, 80, 100, 120):
        for k in range(21):
            f = 10.0 ** (1.0 + 0.2 * k)
            e = modulus(f, temperature)
            out.write(f"{f:.6g},{temperature},{e.real:.6g},"
                      f"{e.imag / e.real:.6g}\n")
