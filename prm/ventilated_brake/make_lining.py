#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes lining.csv: a made-up, plausible modulus of a friction lining.

Linings of brake pads stiffen under pressure, as their pores close, and soften when
they are hot: ultrasonic and compression tests find a few to some 15 GPa, two to three
times as much at 4 MPa as at 0.5 MPa, and a third less at 300 degrees Celsius. Here

    E = E1 (p / 1 MPa)^(2/5) (1 - (T - 20) / 800),  E1 = 6 GPa,

with a loss factor of 0.02 that rises to 0.04 at 300 degrees Celsius, both the same at
all frequencies.
"""
with open("lining.csv", "w", encoding="ascii") as out:
    out.write("# written by make_lining.py, which says what it is\n")
    out.write("pressure_Pa,temperature_C,frequency_Hz,storage_modulus_Pa,"
              "loss_factor\n")
    for pressure in (0.25e6, 0.5e6, 1e6, 2e6, 4e6):
        for temperature in (20, 100, 200, 300):
            for frequency in (100, 20000):
                e = 6e9 * (pressure / 1e6) ** 0.4 * (1 - (temperature - 20) / 800)
                eta = 0.02 + 0.02 * (temperature - 20) / 280
                out.write(f"{pressure:g},{temperature},{frequency},{e:.6g},{eta:.6g}\n")
