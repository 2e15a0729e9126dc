#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A disc between two pads of tetrahedra, whose matrices CalculiX stores.

    make_brake.py deck     writes brake/matrices.inp and brake/modes.inp
    make_brake.py run      ccx -i matrices stores K, M and the names of their
                           rows, ccx -i modes computes the first 30 frequencies
    make_brake.py tables   writes what squeal needs beside: brake/nodes.csv,
                           brake/contact.csv, brake/frequencies.csv

Only Python's own library and CalculiX (ccx) are needed. All of it is quadratic
tetrahedra (C3D10), six for each brick of a grid:

- an annulus of grey iron, 60 to 140 mm, 20 mm thick, its top at z = 0, whose
  bore stands on springs to the ground;
- two soft pads of 1 GPa, 40 x 60 x 15 mm, centred at x = 110 mm above and below it,
  their backs on springs to the ground: stiff ones across, which are the
  abutments, and soft ones along z, which are the seals of the pistons.

The contact is open in the matrices. contact.csv has the three integration
points of each triangle of a pad's face, and where they lie on the triangles of
the disc, whose nodes do not match. Units: m, kg, s, N.

--around, --pad cells of the disc round its axis and of a pad along and across;
--output the folder (brake beside this file).
"""
import argparse
import csv
import itertools
import math
import os
import subprocess

INNER, OUTER, THICKNESS = 0.060, 0.140, 0.020
PAD_CENTRE, PAD_SIZE = 0.110, (0.040, 0.060, 0.015)
# Young's modulus, Poisson's ratio, density
IRON, LINING = (110e9, 0.27, 7200.0), (1e9, 0.3, 2500.0)
# N/m of each node along x, y, z
BORE_SPRINGS = (2e8, 2e8, 2e8)
BACK_SPRINGS = (2e6, 8e6, 1e4)
PRESSURE = 1e6
N_FREQUENCIES = 30


class Grid:
    """Bricks of a grid, each cut into six tetrahedra along one diagonal. Nodes are points
    of the grid of half the size."""

    def __init__(self, name, cells, place, first_node, closed=False):
        self.name, self.cells, self.place, self.closed = name, cells, place, closed
        self.numbers, self.first_node = {}, first_node
        self.elements = [self.nodes(corners) for corners in self.tetrahedra()]

    def node(self, point):
        if self.closed:
            point = (point[0], point[1] % (2 * self.cells[1]), point[2])
        return self.numbers.setdefault(point, self.first_node + len(self.numbers))

    def nodes(self, corners):
        """Corners and the middles of the edges, in the order of C3D10 or of six-node triangles."""
        edges = [(0, 1), (1, 2), (2, 0)]
        if len(corners) == 4:
            edges += [(0, 3), (1, 3), (2, 3)]
        middles = [tuple((corners[a][c] + corners[b][c]) // 2 for c in range(3))
                   for a, b in edges]
        return [self.node(point) for point in list(corners) + middles]

    def tetrahedra(self):
        for cell in itertools.product(*(range(n) for n in self.cells)):
            for order in itertools.permutations(range(3)):
                corners = [tuple(2 * i for i in cell)]
                for axis in order:
                    corners.append(tuple(p + 2 * (c == axis)
                                         for c, p in enumerate(corners[-1])))
                if order not in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
                    corners[2], corners[3] = corners[3], corners[2]
                yield corners

    def triangles(self, cell, level):
        """The two triangles of a brick's face at the bottom (level 0) or top (1)."""
        i, j, k = (2 * cell[0], 2 * cell[1], 2 * self.cells[2] * level)
        a, b, c, d = (i, j, k), (i + 2, j, k), (i + 2, j + 2, k), (i, j + 2, k)
        return [self.nodes((a, b, c)), self.nodes((a, c, d))]

    def places(self):
        """Of all nodes, with the digits that a field of the deck has."""
        return {number: tuple(float("%.12f" % x) + 0.0 for x in self.place(point))
                for point, number in self.numbers.items()}

    def face(self, axis, level):
        """Nodes where a coordinate of the grid is at its lower (0) or upper (1) end."""
        end = 2 * self.cells[axis] * level
        return sorted(n for point, n in self.numbers.items() if point[axis] == end)


def make_bodies(around, pad_cells):
    def on_disc(point):
        radius = INNER + (OUTER - INNER) * point[0] / 2.0
        angle = math.pi * point[1] / around
        return (radius * math.cos(angle), radius * math.sin(angle),
                THICKNESS * (point[2] / 2.0 - 1.0))

    def on_pad(bottom):
        def place(point):
            return (PAD_CENTRE + PAD_SIZE[0] * (point[0] / (2.0 * pad_cells) - 0.5),
                    PAD_SIZE[1] * (point[1] / (2.0 * pad_cells) - 0.5),
                    bottom + PAD_SIZE[2] * point[2] / 2.0)
        return place

    disc = Grid("disc", (1, around, 1), on_disc, 1, closed=True)
    upper = Grid("upper", (pad_cells, pad_cells, 1), on_pad(0.0), 10001)
    lower = Grid("lower", (pad_cells, pad_cells, 1), on_pad(-THICKNESS - PAD_SIZE[2]), 20001)
    return disc, upper, lower


def write_springs(out, name, nodes, stiffnesses, number):
    for component, stiffness in enumerate(stiffnesses, 1):
        elements = "%s_%d" % (name, component)
        out.write("*ELEMENT, TYPE=SPRING1, ELSET=%s\n" % elements)
        for node in nodes:
            out.write("%d, %d\n" % (number, node))
            number += 1
        out.write("*SPRING, ELSET=%s\n%d\n%.6e\n" % (elements, component, stiffness))
    return number


def write_deck(file, bodies, step):
    disc, upper, lower = bodies
    with open(file, "w", encoding="ascii") as out:
        number = 1
        for body in bodies:
            out.write("*NODE\n")
            for node, place in sorted(body.places().items()):
                out.write("%d, %.12f, %.12f, %.12f\n" % ((node,) + place))
            out.write("*ELEMENT, TYPE=C3D10, ELSET=%s\n" % body.name)
            for nodes in body.elements:
                out.write("%d, %s\n" % (number, ", ".join(map(str, nodes))))
                number += 1
            modulus, ratio, density = IRON if body is disc else LINING
            out.write("*MATERIAL, NAME=%s\n*ELASTIC\n%.16g, %.16g\n*DENSITY\n%.16g\n"
                      % (body.name, modulus, ratio, density))
            out.write("*SOLID SECTION, ELSET=%s, MATERIAL=%s\n" % (body.name, body.name))
        number = write_springs(out, "bore", disc.face(0, 0), BORE_SPRINGS, number)
        number = write_springs(out, "back_upper", upper.face(2, 1), BACK_SPRINGS, number)
        write_springs(out, "back_lower", lower.face(2, 0), BACK_SPRINGS, number)
        out.write("*STEP\n*FREQUENCY%s\n%d\n*END STEP\n" % (step, N_FREQUENCIES))


def digits(value):
    return "%.13g" % value


def shape_functions(b):
    """Of the six-node triangle at barycentric coordinates b."""
    return [b[0] * (2 * b[0] - 1), b[1] * (2 * b[1] - 1), b[2] * (2 * b[2] - 1),
            4 * b[0] * b[1], 4 * b[1] * b[2], 4 * b[2] * b[0]]


def shape_gradients(b):
    """Along the first two barycentric coordinates, the third making up for them."""
    along = [[4 * b[0] - 1, 0, 0, 4 * b[1], 0, 4 * b[2]],
             [0, 4 * b[1] - 1, 0, 4 * b[0], 4 * b[2], 0],
             [0, 0, 4 * b[2] - 1, 0, 4 * b[1], 4 * b[0]]]
    return [[along[a][i] - along[2][i] for i in range(6)] for a in range(2)]


def locate(point, triangle, places):
    """Barycentric coordinates of a point on a curved triangle by Newton's method, or None."""
    b = [1 / 3.0, 1 / 3.0, 1 / 3.0]
    for _ in range(50):
        n = shape_functions(b)
        r = [point[c] - sum(w * places[node][c] for w, node in zip(n, triangle))
             for c in range(2)]
        j = [[sum(w * places[node][c] for w, node in zip(row, triangle))
              for row in shape_gradients(b)] for c in range(2)]
        det = j[0][0] * j[1][1] - j[0][1] * j[1][0]
        step = [(r[0] * j[1][1] - r[1] * j[0][1]) / det, (r[1] * j[0][0] - r[0] * j[1][0]) / det]
        b = [b[0] + step[0], b[1] + step[1], b[2] - step[0] - step[1]]
        if max(map(abs, b)) > 10:
            return None
        if max(map(abs, step)) < 1e-14:
            return b if min(b) > -1e-9 else None
    return None


def target_weights(point, disc, level, places):
    """Nodes of the disc's face and their shape functions at a point."""
    cell = int(math.atan2(point[1], point[0]) % (2 * math.pi) / (2 * math.pi) * disc.cells[1])
    for near in (cell, cell - 1, cell + 1):
        for triangle in disc.triangles((0, near % disc.cells[1]), level):
            b = locate(point, triangle, places)
            if b is not None:
                return list(zip(triangle, shape_functions(b)))
    raise SystemExit("a point of a pad lies beside the disc: %s" % (point,))


def integration_points(triangle, places):
    """Place, area and shape functions at the three points of a plane triangle."""
    (x0, y0, _), (x1, y1, _), (x2, y2, _) = (places[node] for node in triangle[:3])
    area = abs((x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)) / 2.0
    for corner in range(3):
        n = shape_functions([2 / 3.0 if c == corner else 1 / 6.0 for c in range(3)])
        place = tuple(sum(w * places[node][c] for w, node in zip(n, triangle)) for c in range(3))
        yield place, area / 3.0, list(zip(triangle, n))


def contact_rows(pad, disc, places):
    """Lines of contact.csv. The disc turns about +z."""
    above = pad.name == "upper"
    normal = (0.0, 0.0, 1.0 if above else -1.0)
    pair = 0
    for cell in itertools.product(range(pad.cells[0]), range(pad.cells[1])):
        for triangle in pad.triangles(cell, 0 if above else 1):
            for place, area, source in integration_points(triangle, places):
                pair += 1
                radius = math.hypot(place[0], place[1])
                t = (-place[1] / radius, place[0] / radius, 0.0)
                s = (t[1] * normal[2], -t[0] * normal[2], 0.0)
                target = target_weights(place, disc, 1 if above else 0, places)
                for direction, d in (("normal", normal), ("sliding", t), ("transverse", s)):
                    for side, weights in (("target", target), ("source", source)):
                        for node, weight in weights:
                            for component in range(3):
                                if weight * d[component] != 0.0:
                                    yield ([pad.name, pair, side, direction, node, component + 1,
                                            digits(weight * d[component])]
                                           + [digits(x) for x in place]
                                           + [digits(area), digits(radius / PAD_CENTRE)])


def pressed_nodes(pad):
    """Forces of the pressure on a pad's back: a third of each triangle on its middles."""
    places = pad.places()
    above, forces = pad.name == "upper", {}
    for cell in itertools.product(range(pad.cells[0]), range(pad.cells[1])):
        for triangle in pad.triangles(cell, 1 if above else 0):
            area = sum(a for _, a, _ in integration_points(triangle, places))
            for node in triangle[3:]:
                forces[node] = forces.get(node, 0.0) + area / 3.0 * PRESSURE * (-1 if above else 1)
    return forces


def write_tables(folder, bodies):
    places, body_of, forces = {}, {}, []
    for body in bodies:
        places.update(body.places())
        body_of.update((node, body.name) for node in body.places())
    for pad in bodies[1:]:
        forces.append(pressed_nodes(pad))
    with open(os.path.join(folder, "matrices.dof"), encoding="ascii") as file:
        rows = [tuple(map(int, line.strip().split("."))) for line in file]
    with open(os.path.join(folder, "nodes.csv"), "w", encoding="ascii", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow("dof node component x y z body load_upper load_lower".split())
        for dof, (node, component) in enumerate(rows, 1):
            table.writerow([dof, node, component] + [digits(x) for x in places[node]]
                           + [body_of[node]]
                           + [digits(f.get(node, 0.0)) if component == 3 else 0 for f in forces])
    with open(os.path.join(folder, "contact.csv"), "w", encoding="ascii", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow("contact pair side direction node component weight x y z area "
                       "speed_ratio".split())
        for pad in bodies[1:]:
            table.writerows(contact_rows(pad, bodies[0], places))
    with open(os.path.join(folder, "modes.dat"), encoding="ascii") as file:
        modes = [line.split() for line in file]
    with open(os.path.join(folder, "frequencies.csv"), "w", encoding="ascii", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(["mode", "frequency_hz"])
        for fields in modes:
            # number, eigenvalue, frequency in rad/s, in Hz, its imaginary part
            if len(fields) == 5 and fields[0].isdigit():
                # The eigenvalue has the most digits that are printed.
                table.writerow([fields[0], repr(math.sqrt(float(fields[1])) / (2 * math.pi))])


def run_calculix(folder):
    for job in ("matrices", "modes"):
        done = subprocess.run(["ccx", "-i", job], cwd=folder, stdout=subprocess.PIPE,
                              encoding="utf-8", errors="replace")
        # ccx ends with 201 after an error, and some versions with 0.
        if done.returncode or "Job finished" not in done.stdout:
            raise SystemExit("ccx -i %s:\n%s" % (job, done.stdout[-2000:]))
        for ending in ("12d", "cvg", "sta", "frd"):
            path = os.path.join(folder, job + "." + ending)
            if os.path.exists(path):
                os.remove(path)
    for left in ("matrices.dat", "spooles.out"):
        path = os.path.join(folder, left)
        if os.path.exists(path):
            os.remove(path)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("deck", "run", "tables"))
    parser.add_argument("--around", type=int, default=16)
    parser.add_argument("--pad", type=int, default=2)
    parser.add_argument("--output",
                        default=os.path.join(os.path.dirname(os.path.realpath(__file__)), "brake"))
    options = parser.parse_args()
    if options.what == "run":
        return run_calculix(options.output)
    bodies = make_bodies(options.around, options.pad)
    if options.what == "tables":
        return write_tables(options.output, bodies)
    os.makedirs(options.output, exist_ok=True)
    write_deck(os.path.join(options.output, "matrices.inp"), bodies, ", SOLVER=MATRIXSTORAGE")
    write_deck(os.path.join(options.output, "modes.inp"), bodies, "")


if __name__ == "__main__":
    main()
