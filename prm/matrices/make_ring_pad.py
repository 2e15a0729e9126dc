#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the sample model of prm/matrices: a ring of point masses and a pad.

Only Python's own library is needed. The same matrices are written in the three
formats that can be imported (../../doc/import.md):

  ring_pad/market/*.mtx     MatrixMarket, half of each symmetric matrix
  ring_pad/abaqus/*.mtx     Abaqus, FORMAT=MATRIX INPUT (and, for the mass,
                            FORMAT=COORDINATE)
  ring_pad/nastran/ring_pad.pch  Nastran DMIG in large field format
  ring_pad/nodes.csv, ring_pad/contact.csv  node table and contact pattern

The ring: 24 masses on a circle of radius 0.1 m, joined along z by springs that
feel differences and second differences of the displacement, in the plane by
springs along the chords, and each to the ground along x, y, z. Without the pad
all its modes with m = 1 to 11 waves are doublets.

The pad: 12 masses in two layers of 2 x 3, joined by springs along x, y, z and by
struts across its height, which join its motions along and across the ring. The
stiffness is proportional to the modulus of the pad (the part `pad` is for
1 GPa). Its upper layer hangs on springs to the ground. Each of the six
nodes of its lower layer presses on the ring, half-way or a third of the way
between two masses, so that the contact does not match.

Units: m, kg, s, N. Values have nine significant digits, so that the fields of
16 columns of Nastran hold them exactly.
"""
import math
import os

N_RING = 24
RADIUS = 0.1
RING_MASS = 0.08
RING_GROUND = {1: 4.0e8, 2: 4.0e8, 3: 2.0e7}
RING_SHEAR = 3.0e7
RING_BENDING = 4.0e7
RING_CHORD = 2.0e8
PAD_MASS = 0.004
PAD_HEIGHT = 0.025
PAD_SPRINGS = {1: 1.2e6, 2: 1.2e6, 3: 2.0e6}
PAD_STRUT = 3.0e6
PAD_SUPPORT = {1: 2.0e6, 2: 6.0e5, 3: 2.0e5}
MASS_DAMPING = 5.0
STIFFNESS_DAMPING = 1.0e-8


class Matrix:
    """A symmetric matrix over (node, component)."""

    def __init__(self):
        self.entries = {}

    def add(self, row, column, value):
        if row < column:
            row, column = column, row
        self.entries[row, column] = self.entries.get((row, column), 0.0) + value

    def add_row(self, weights, stiffness):
        """Adds stiffness times the square of sum(weights * u)."""
        items = sorted(weights.items())
        for i, (dof_i, weight_i) in enumerate(items):
            for dof_j, weight_j in items[: i + 1]:
                self.add(dof_i, dof_j, stiffness * weight_i * weight_j)

    def rounded(self):
        """Entries by column and row, nine digits, without rounding errors."""
        negligible = 1e-14 * max(abs(v) for v in self.entries.values())
        return sorted(
            ((row, column, float("%.8e" % v))
             for (row, column), v in self.entries.items()
             if abs(v) > negligible),
            key=lambda entry: (entry[1], entry[0]),
        )


def ring_node(i):
    return 1 + i % N_RING


def pad_node(layer, i, j):
    return 101 + 6 * layer + 3 * i + j


def positions():
    """Place and body of every node."""
    places = {}
    for i in range(N_RING):
        angle = 2.0 * math.pi * i / N_RING
        x, y = RADIUS * math.cos(angle), RADIUS * math.sin(angle)
        places[ring_node(i)] = (x, y, 0.0, "ring")
    for layer in range(2):
        for i in range(2):
            for j in range(3):
                angle = pad_angle(i, j)
                radius = RADIUS * (0.95 + 0.1 * i)
                x, y = radius * math.cos(angle), radius * math.sin(angle)
                places[pad_node(layer, i, j)] = (x, y, PAD_HEIGHT * layer, "pad")
    return places


def pad_angle(i, j):
    """Angle of a pad node: thirds of a gap, shifted from row to row."""
    gap = 2.0 * math.pi / N_RING
    return gap * ((j - 1) * 4.0 / 3.0 + (0.5 if i else 1.0 / 3.0))


def ring_stiffness():
    matrix = Matrix()
    for i in range(N_RING):
        here, after, before = ring_node(i), ring_node(i + 1), ring_node(i - 1)
        for component, stiffness in RING_GROUND.items():
            matrix.add_row({(here, component): 1.0}, stiffness)
        matrix.add_row({(after, 3): 1.0, (here, 3): -1.0}, RING_SHEAR)
        matrix.add_row(
            {(after, 3): 1.0, (here, 3): -2.0, (before, 3): 1.0}, RING_BENDING
        )
        angle = 2.0 * math.pi * (i + 0.5) / N_RING
        along = {1: -math.sin(angle), 2: math.cos(angle)}
        chord = {}
        for component, cosine in along.items():
            chord[after, component] = cosine
            chord[here, component] = -cosine
        matrix.add_row(chord, RING_CHORD)
    return matrix


def pad_stiffness():
    """For a modulus of 1 GPa, support springs left out."""
    matrix = Matrix()
    for component, stiffness in PAD_SPRINGS.items():
        for layer in range(2):
            for i in range(2):
                for j in range(3):
                    here = pad_node(layer, i, j)
                    others = []
                    if layer == 0:
                        others.append(pad_node(1, i, j))
                    if i == 0:
                        others.append(pad_node(layer, 1, j))
                    if j < 2:
                        others.append(pad_node(layer, i, j + 1))
                    for other in others:
                        matrix.add_row(
                            {(here, component): 1.0, (other, component): -1.0},
                            stiffness,
                        )
    for lower, upper in pad_struts():
        matrix.add_row(strut(lower, upper), PAD_STRUT)
    return matrix


def pad_struts():
    """Each lower node with the upper ones beside the one above it."""
    for i in range(2):
        for j in range(3):
            for other in ((1 - i, j), (i, j - 1), (i, j + 1)):
                if 0 <= other[1] < 3:
                    yield pad_node(0, i, j), pad_node(1, *other)


def strut(first, second):
    """Change of the distance of two nodes."""
    places = positions()
    along = [b - a for a, b in zip(places[first][:3], places[second][:3])]
    length = math.sqrt(sum(value * value for value in along))
    weights = {}
    for component, value in enumerate(along, 1):
        weights[first, component] = -value / length
        weights[second, component] = value / length
    return weights


def support_stiffness():
    matrix = Matrix()
    for i in range(2):
        for j in range(3):
            for component, stiffness in PAD_SUPPORT.items():
                matrix.add_row({(pad_node(1, i, j), component): 1.0}, stiffness)
    return matrix


def mass():
    matrix = Matrix()
    for node, place in positions().items():
        value = RING_MASS if place[3] == "ring" else PAD_MASS
        for component in (1, 2, 3):
            matrix.add((node, component), (node, component), value)
    return matrix


def damping(parts):
    """MASS_DAMPING M + STIFFNESS_DAMPING K of the ring and the support."""
    matrix = Matrix()
    for factor, part in parts:
        for (row, column), value in part.entries.items():
            matrix.add(row, column, factor * value)
    return matrix


def contact_lines():
    """One line a weight: pair, side, direction, node, component, weight."""
    gap = 2.0 * math.pi / N_RING
    pair = 0
    for i in range(2):
        for j in range(3):
            pair += 1
            angle = pad_angle(i, j)
            first = math.floor(angle / gap + 1e-9)
            share = angle / gap - first
            shares = [("target", ring_node(first), 1.0 - share),
                      ("target", ring_node(first + 1), share),
                      ("source", pad_node(0, i, j), 1.0)]
            slide = {1: -math.sin(angle), 2: math.cos(angle)}
            across = {1: math.cos(angle), 2: math.sin(angle)}
            for direction, cosines in (("normal", {3: 1.0}),
                                       ("sliding", slide),
                                       ("transverse", across)):
                for side, node, weight in shares:
                    for component, cosine in cosines.items():
                        yield "%d,%s,%s,%d,%d,%.15g" % (
                            pair, side, direction, node, component,
                            weight * cosine)


def write(name, lines):
    """Writes under a temporary name first."""
    os.makedirs(os.path.dirname(name), exist_ok=True)
    with open(name + ".part", "w", encoding="ascii") as stream:
        stream.writelines(line + "\n" for line in lines)
    os.replace(name + ".part", name)


def market_lines(matrix, number):
    entries = matrix.rounded()
    yield "%%MatrixMarket matrix coordinate real symmetric"
    yield "% rows sorted by node and component, see ../nodes.csv"
    yield "%d %d %d" % (len(number), len(number), len(entries))
    for row, column, value in entries:
        yield "%d %d %.9g" % (number[row], number[column], value)


def abaqus_lines(matrix):
    for row, column, value in matrix.rounded():
        yield "%d,%d, %d,%d, %21.15e" % (row + column + (value,))


def coordinate_lines(matrix, number):
    for row, column, value in matrix.rounded():
        yield "%d %d %21.15e" % (number[row], number[column], value)
        if row != column:
            yield "%d %d %21.15e" % (number[column], number[row], value)


def nastran_lines(matrix, name):
    yield "DMIG    %-8s%8d%8d%8d%8d" % (name, 0, 6, 2, 0)
    last = None
    for row, column, value in matrix.rounded():
        if column != last:
            yield "DMIG*   %-16s%16d%16d" % ((name,) + column)
            last = column
        number = ("%16.9E" % value).replace("E", "D")
        yield "*       %16d%16d%16s" % (row + (number,))


def main():
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "ring_pad")
    places = positions()
    dofs = [(node, component) for node in sorted(places)
            for component in (1, 2, 3)]
    number = {dof: i + 1 for i, dof in enumerate(dofs)}
    ring, pad, support, masses = (
        ring_stiffness(), pad_stiffness(), support_stiffness(), mass())
    losses = damping([(MASS_DAMPING, masses), (STIFFNESS_DAMPING, ring),
                      (STIFFNESS_DAMPING, support)])
    parts = {"mass": (masses, "MAAX"), "ring": (ring, "KRING"),
             "pad": (pad, "KPAD"), "support": (support, "KSUPP"),
             "damping": (losses, "BAAX")}

    for name, (matrix, _) in parts.items():
        write(os.path.join(folder, "market", name + ".mtx"),
              market_lines(matrix, number))
        write(os.path.join(folder, "abaqus", name + ".mtx"),
              abaqus_lines(matrix))
    write(os.path.join(folder, "abaqus", "ring_coordinate.mtx"),
          coordinate_lines(ring, number))
    punch = ["$ sample model of squeal, written by make_ring_pad.py"]
    for matrix, name in parts.values():
        punch.extend(nastran_lines(matrix, name))
    write(os.path.join(folder, "nastran", "ring_pad.pch"), punch)

    table = ["dof,node,component,x,y,z,body"]
    for dof in dofs:
        table.append("%d,%d,%d,%.9g,%.9g,%.9g,%s" %
                     ((number[dof],) + dof + places[dof[0]]))
    write(os.path.join(folder, "nodes.csv"), table)
    write(os.path.join(folder, "contact.csv"),
          ["pair,side,direction,node,component,weight"] + list(contact_lines()))


if __name__ == "__main__":
    main()
