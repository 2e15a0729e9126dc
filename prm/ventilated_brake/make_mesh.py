#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the meshes of prm/ventilated_brake: a ventilated disc and two pads.

    make_mesh.py --output brake.msh                    # the shipped mesh
    make_mesh.py --output graded.msh --coarsening 3 --rings 2,2 --vane-layers 2 \\
        --hole 3,3,2 --hat 1,3 --grading 3,3,6,3               # that of cea.prm

Only Python's own library is needed. The disc (hat, flange with five bolt holes,
connecting ring, two friction rings, 21 straight vanes) is one conforming mesh
of hexahedra: a plan of quadrilaterals of which every region is drawn up over
its own layers. The pads are bodies of their own. Gmsh format 2.2, lengths in m.

    volumes    disc, pad_lower, pad_upper
    surfaces   lower_ring, upper_ring, bore, bolt_holes of the disc;
               friction, back of each pad

In the friction rings the lines of the mesh follow the straight sides of the
vanes: there are 21 (vane + gap) cells round. In hat and flange the same lines
are spread over five sectors of 72 degrees, one for each bolt, each with evenly
spaced lines; between the two, the connecting ring leads from one to the other.
With `--coarsening 3` hat and flange have a third of the rings' lines: the layer
of the connecting ring next to the rings joins three cells to one.

`--turn DEGREES` turns the disc under the pads. The cells have straight edges:
with the default numbers round this moves frequencies by less than 0.1 %.
"""
import argparse
import math

RING_INNER, RING_OUTER = 0.125, 0.175
LOWER, UPPER = (0.0, 0.010), (0.025, 0.035)      # the rings along z
CONNECTION_INNER = 0.1125
HAT_INNER, HAT_HEIGHT = 0.105, 0.075
BORE, FLANGE_BOTTOM = 0.040, 0.065
HOLES, HOLE_RADIUS, HOLE_CIRCLE = 5, 0.010, 0.075
SQUARE = 0.055, 0.095         # radii between which a hole has its own cells
VANES, VANE_SIDES = 21, (-0.01374, 0.01496)      # of the vane beside the y axis
PAD_RADII, PAD_ANGLE, PAD_THICKNESS = (0.130, 0.1675), math.radians(30), 0.015


def even(first, last, cells):
    return [first + (last - first) * i / cells for i in range(cells + 1)]


def graded(first, last, cells, ratio, both_ends=False):
    """Sizes fall geometrically from the largest to the smallest, which is the
    ratio times smaller: at the last, or from the middle to both ends."""
    places = [i / max(cells - 1, 1) for i in range(cells)]
    if both_ends:
        places = [abs(2 * p - 1) for p in places]
    sizes = [ratio ** -p for p in places]
    return [first + (last - first) * sum(sizes[:i]) / sum(sizes)
            for i in range(cells)] + [last]


def between(first, last, share):
    return tuple(a + (b - a) * share for a, b in zip(first, last))


def joined(*parts):
    """Levels of several intervals, each border once."""
    return list(parts[0]) + [z for part in parts[1:] for z in part[1:]]


def from_y(radius, angle):
    """The point at an angle from +y towards +x."""
    return radius * math.sin(angle), radius * math.cos(angle)


class Mesh:
    """Hexahedra and named quadrilaterals; points that coincide are one node."""

    def __init__(self):
        self.nodes = []
        self.index = {}
        self.cells = []     # (volume, eight nodes)
        self.faces = []     # (surface, four nodes)

    def node(self, x, y, z):
        key = tuple(round(c * 1e8) for c in (x, y, z))
        if key not in self.index:
            self.index[key] = len(self.nodes)
            self.nodes.append((x, y, z))
        return self.index[key]

    def draw_up(self, quads, levels, volume):
        """Cells over quadrilaterals of points (x, y), from level to level."""
        for quad in quads:
            layers = [[self.node(x, y, z) for x, y in quad] for z in levels]
            for bottom, top in zip(layers, layers[1:]):
                self.cells.append((volume, bottom + top))

    def level_face(self, quads, z, surface):
        for quad in quads:
            self.faces.append((surface, [self.node(x, y, z) for x, y in quad]))

    def side_face(self, edges, levels, surface):
        for (xa, ya), (xb, yb) in edges:
            for low, high in zip(levels, levels[1:]):
                self.faces.append((surface, [
                    self.node(xa, ya, low), self.node(xb, yb, low),
                    self.node(xb, yb, high), self.node(xa, ya, high)]))


def quads_between(lines):
    """Quadrilaterals between neighbouring lines of points, which have equally
    many; counter-clockwise if the lines follow each other clockwise and their
    points go outwards."""
    return [(b[i], b[i + 1], a[i + 1], a[i])
            for a, b in zip(lines, lines[1:]) for i in range(len(a) - 1)]


class Plan:
    """The quadrilaterals of the disc's regions seen along its axis."""

    def __init__(self, options):
        self.vane, self.gap = options.vane
        self.options = options
        self.per_pitch = self.vane + self.gap
        self.round = VANES * self.per_pitch
        self.ratio = options.coarsening     # cells of the rings to one of the hat
        if self.round % self.ratio:
            raise SystemExit(f"--coarsening: {self.round} cells round the rings "
                             f"are no multiple of {self.ratio}")
        self.hat_round = self.round // self.ratio
        self.borders = [round((i - 0.5) * self.hat_round / HOLES +
                              self.vane / (2 * self.ratio))
                        for i in range(HOLES)]     # lines between the sectors
        self.borders.append(self.borders[0] + self.hat_round)
        self.turn = math.radians(options.turn)
        self.make_rings()
        self.make_flange()

    def point(self, radius, angle):
        return from_y(radius, angle + self.turn)

    def even_angle(self, k):
        """Of line k in hat and flange. The middle of the first sector is at
        +y, where that of the first vane is, all but a third of a degree."""
        turns, k = divmod(k - self.borders[0], self.hat_round)
        k += self.borders[0]
        sector = max(i for i in range(HOLES) if self.borders[i] <= k)
        first, last = self.borders[sector:sector + 2]
        return (turns * HOLES + sector - 0.5 + (k - first) / (last - first)
                ) * 2 * math.pi / HOLES

    def ring_angle(self, k, radius):
        """Of line k in the rings: along the vane's sides, whose distance from
        the radial line through the vane's middle is the same everywhere."""
        pitch, line = divmod(k, self.per_pitch)
        left, right = VANE_SIDES
        if line <= self.vane:
            x = graded(left, right, self.vane, self.options.grading[1],
                       True)[line]
            angle = math.asin(x / radius)
        else:
            start = math.asin(right / radius)
            end = math.asin(left / radius) + 2 * math.pi / VANES
            angle = start + (end - start) * (line - self.vane) / self.gap
        return angle + pitch * 2 * math.pi / VANES

    def make_rings(self):
        o = self.options
        lines = [[self.point(r, self.ring_angle(k, r))
                  for r in even(RING_INNER, RING_OUTER, o.rings[0])]
                 for k in range(self.round + 1)]
        self.rings = quads_between(lines)
        self.vanes = [quad for k in range(self.round)
                      if k % self.per_pitch < self.vane
                      for quad in quads_between(lines[k:k + 2])]
        self.hat = quads_between(
            [[self.point(r, self.even_angle(k))
              for r in even(HAT_INNER, CONNECTION_INNER, o.hat[0])]
             for k in range(self.hat_round + 1)])
        self.make_connection([line[0] for line in lines])

    def make_connection(self, outer):
        """From the hat's lines to those of the rings. @p outer: the points of
        the rings' lines at their inner radius."""
        steps = even(0., 1., self.options.connection)
        lines = [[between(self.point(CONNECTION_INNER, self.even_angle(k)),
                          outer[self.ratio * k], s) for s in steps]
                 for k in range(self.hat_round + 1)]
        if self.ratio == 1:
            self.connection = quads_between(lines)
            return
        self.connection = quads_between([line[:-1] for line in lines])
        for k in range(self.hat_round):
            a, b = lines[k][-2], lines[k + 1][-2]
            fine = outer[3 * k:3 * k + 4]
            left, right = (between(between(a, b, s), point, 0.5)
                           for s, point in zip((1 / 3, 2 / 3), fine[1:3]))
            self.connection += [(b, right, left, a), (left, fine[1], fine[0], a),
                                (right, fine[2], fine[1], left),
                                (b, fine[3], fine[2], right)]

    def make_flange(self):
        """Five sectors, each of three by three blocks; the one in the middle is
        replaced by rings of cells round the hole."""
        o = self.options
        radii = joined(even(BORE, SQUARE[0], o.flange[0]),
                       even(*SQUARE, o.hole[1]),
                       graded(SQUARE[1], HAT_INNER, o.flange[1], o.grading[3]))
        self.flange, self.bore, self.holes = [], [], []
        for sector in range(HOLES):
            first, last = self.borders[sector:sector + 2]
            cells = last - first
            middle = o.hole[0] - (cells - o.hole[0]) % 2
            side = (cells - middle) // 2
            if side < 1:
                raise SystemExit(f"--hole: fewer than {cells} cells round")
            grid = [[self.point(r, self.even_angle(k)) for r in radii]
                    for k in range(first, last + 1)]
            self.bore += [(a[0], b[0]) for a, b in zip(grid, grid[1:])]
            inner = o.flange[0]
            outer = inner + o.hole[1]
            for k in range(cells):
                parts = ([slice(0, inner + 1), slice(outer, None)]
                         if side <= k < side + middle else [slice(None)])
                for part in parts:
                    self.flange += quads_between(
                        [grid[k][part], grid[k + 1][part]])
            self.add_hole([line[inner:outer + 1]
                           for line in grid[side:side + middle + 1]],
                          sector * 2 * math.pi / HOLES)

    def add_hole(self, square, direction):
        """Cells between a square of points, lines along the radius, and the
        hole, a regular polygon of the circle's area: clamped walls inside the
        circle would make the flange too soft. @p direction: angle of the
        hole's middle from +y."""
        n, m = len(square) - 1, len(square[0]) - 1
        # clockwise round the square, from its inner corner towards -x
        edge = (square[0] + [line[m] for line in square[1:]] +
                square[n][m - 1::-1] + [line[0] for line in square[n - 1:0:-1]])
        angle = math.pi / (n + m)
        radius = HOLE_RADIUS * (1 if self.options.on_circle else
                                math.sqrt(angle / math.sin(angle)))
        centre = self.point(HOLE_CIRCLE, direction)
        rays = []
        for i, outer in enumerate(edge):
            offset = from_y(radius, direction + self.turn +
                            (i - m - n / 2) * angle)
            inner = centre[0] + offset[0], centre[1] + offset[1]
            rays.append([(inner[0] + (outer[0] - inner[0]) * s,
                          inner[1] + (outer[1] - inner[1]) * s)
                         for s in graded(1., 0., self.options.hole[2],
                                         self.options.grading[3])[::-1]])
        rays.append(rays[0])
        self.flange += quads_between(rays)
        self.holes += [(a[0], b[0]) for a, b in zip(rays, rays[1:])]


def add_disc(mesh, options):
    plan = Plan(options)
    ring, vane, flange = options.rings[1], options.vane_layers, options.flange[2]
    ratio = options.grading[0]
    lower = graded(*LOWER, ring, ratio)
    upper = graded(*UPPER[::-1], ring, ratio)[::-1]
    gap = graded(LOWER[1], UPPER[0], vane, ratio, True)
    top = even(FLANGE_BOTTOM, HAT_HEIGHT, flange)
    wall = graded(LOWER[1], FLANGE_BOTTOM, options.hat[1], options.grading[2],
                  True)
    hat = joined(lower, wall, top)
    for quads, levels in ((plan.rings, lower), (plan.rings, upper),
                          (plan.vanes, gap),
                          (plan.connection, lower), (plan.hat, hat),
                          (plan.flange, top)):
        mesh.draw_up(quads, levels, "disc")
    mesh.level_face(plan.rings, LOWER[0], "lower_ring")
    mesh.level_face(plan.rings, UPPER[1], "upper_ring")
    mesh.side_face(plan.bore, top, "bore")
    mesh.side_face(plan.holes, top, "bolt_holes")


def add_pad(mesh, options, face, back, volume):
    round_, radial, layers = options.pads
    lines = [[from_y(r, a) for r in even(*PAD_RADII, radial)]
             for a in even(-PAD_ANGLE, PAD_ANGLE, round_)]
    quads = quads_between(lines)
    mesh.index.clear()      # the pads touch the disc, but share no nodes
    mesh.draw_up(quads, even(min(face, back), max(face, back), layers), volume)
    mesh.level_face(quads, face, "friction")
    mesh.level_face(quads, back, "back")


def write(mesh, name):
    surfaces = list(dict.fromkeys(s for s, _ in mesh.faces))
    volumes = list(dict.fromkeys(v for v, _ in mesh.cells))
    tags = {n: i + 1 for i, n in enumerate(surfaces + volumes)}
    with open(name, "w") as out:
        out.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                  f"$PhysicalNames\n{len(tags)}\n")
        for n, tag in tags.items():
            out.write(f'{2 if n in surfaces else 3} {tag} "{n}"\n')
        out.write(f"$EndPhysicalNames\n$Nodes\n{len(mesh.nodes)}\n")
        for i, x in enumerate(mesh.nodes):
            out.write(f"{i + 1} " + " ".join(f"{c:.10g}" for c in x) + "\n")
        elements = ([(3, n, q) for n, q in mesh.faces] +
                    [(5, n, c) for n, c in mesh.cells])
        out.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        for i, (kind, n, nodes) in enumerate(elements):
            out.write(f"{i + 1} {kind} 2 {tags[n]} {tags[n]} " +
                      " ".join(str(k + 1) for k in nodes) + "\n")
        out.write("$EndElements\n")


def numbers(count, kind=int):
    def read(text):
        values = tuple(kind(part) for part in text.split(","))
        if len(values) != count or min(values) < 1:
            raise argparse.ArgumentTypeError(f"give {count} numbers from 1 on")
        return values
    return read


def grading(text):
    parts = text.split(",")
    return numbers(4, float)(",".join(parts + ["1"] * (4 - len(parts))))


def make(arguments=None):
    parser = argparse.ArgumentParser(
        description="Mesh of the ventilated brake, in numbers of cells.")
    add = parser.add_argument
    add("--output", required=True)
    add("--rings", type=numbers(2), default=(2, 1), help="radial,layers")
    add("--vane", type=numbers(2), default=(3, 2),
        help="round, of a vane and of a gap")
    add("--vane-layers", type=int, default=1)
    add("--grading", type=grading, default=(1., 1., 1., 1.),
        help="largest over smallest cell: of the layers of rings and vanes, "
        "round in the vanes, along the height of the hat, of the flange outside "
        "the bolts and inside the squares; small where walls meet and at "
        "the bolts; numbers left out at the end are 1")
    add("--connection", type=int, default=1, help="radial")
    add("--coarsening", type=int, choices=(1, 3), default=1,
        help="cells round the rings to one round the hat")
    add("--hat", type=numbers(2), default=(1, 2), help="wall,height")
    add("--flange", type=numbers(3), default=(1, 1, 1),
        help="radial inside and outside the bolts,layers")
    add("--hole", type=numbers(3), default=(7, 3, 2),
        help="round and radial on the square round a bolt hole,inside it")
    add("--on-circle", action="store_true",
        help="corners of the bolt holes on the circle, for curved cells")
    add("--pads", type=numbers(3), default=(10, 3, 1),
        help="round,radial,layers")
    add("--no-pads", action="store_true")
    add("--turn", type=float, default=0., help="of the disc, clockwise, degrees")
    options = parser.parse_args(arguments)
    mesh = Mesh()
    add_disc(mesh, options)
    if not options.no_pads:
        add_pad(mesh, options, LOWER[0], LOWER[0] - PAD_THICKNESS, "pad_lower")
        add_pad(mesh, options, UPPER[1], UPPER[1] + PAD_THICKNESS, "pad_upper")
    write(mesh, options.output)
    print(f"{options.output}: {len(mesh.nodes)} nodes, {len(mesh.cells)} cells")


if __name__ == "__main__":
    make()
