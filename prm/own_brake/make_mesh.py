#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes the mesh of prm/own_brake with Gmsh: a disc with a hat between two pads.

    python3 -m venv gmsh-venv && gmsh-venv/bin/pip install gmsh
    gmsh-venv/bin/python make_mesh.py --output brake.msh

Every part is a rectangle of the r-z plane that is turned about the z axis: the ring, the hat
and the flange of the disc by 360 degrees, the lining and the plate of each pad by the angle
of the pad. Cells are hexahedra of second order, so that round edges are round. Gmsh format
4.1, lengths in m.

    volumes    disc, lining_upper, plate_upper, lining_lower, plate_lower
    surfaces   top_ring, bottom_ring, bore of the disc; face and glue of a lining; glue,
               back and ends of a plate

The options change the design; --round and --across change the size of the cells.
"""
import argparse
import math

import gmsh

geo = gmsh.model.geo
BORE, HAT_INNER, HAT_OUTER = 0.030, 0.064, 0.070
HAT_HEIGHT, FLANGE = 0.030, 0.006
PAD_INNER, PAD_OUTER = 0.088, 0.122
LINING, PLATE = 0.010, 0.005


def turned(rectangles, first, last, cells_round):
    """Turns rectangles (r0, r1, z0, z1, cells along r, along z) about z, in quarters.

    Rectangles that share an edge make parts that share a surface. Returns the volumes and
    for each rectangle its surfaces at 'bottom', 'outer', 'top', 'inner' and 'ends'.
    """
    points, lines = {}, {}

    def point(r, z):
        if (r, z) not in points:
            points[r, z] = geo.addPoint(r * math.cos(first), r * math.sin(first), z)
        return points[r, z]

    def line(a, b, cells):
        if (b, a) in lines:
            return -lines[b, a]
        lines[a, b] = geo.addLine(point(*a), point(*b))
        geo.mesh.setTransfiniteCurve(lines[a, b], cells + 1)
        return lines[a, b]

    faces = []
    for r0, r1, z0, z1, cells_r, cells_z in rectangles:
        corners = (r0, z0), (r1, z0), (r1, z1), (r0, z1)
        edges = [line(corners[i], corners[(i + 1) % 4], (cells_r, cells_z)[i % 2])
                 for i in range(4)]
        faces.append(geo.addPlaneSurface([geo.addCurveLoop(edges)]))
        geo.mesh.setTransfiniteSurface(faces[-1], "Left", [point(*c) for c in corners])
        geo.mesh.setRecombine(2, faces[-1])
    sides = "bottom", "outer", "top", "inner"
    volumes = []
    surfaces = [{side: [] for side in sides} for _ in faces]
    pieces = math.ceil((last - first) / (math.pi / 2) - 1e-9)
    begin = faces
    for _ in range(pieces):
        made = geo.revolve([(2, face) for face in begin], 0, 0, 0, 0, 0, 1,
                           (last - first) / pieces, [cells_round // pieces], recombine=True)
        begin = [made[6 * i][1] for i in range(len(faces))]
        for i, named in enumerate(surfaces):
            volumes.append(made[6 * i + 1][1])
            for side, (_, surface) in zip(sides, made[6 * i + 2:6 * i + 6]):
                named[side].append(surface)
    for named, start, end in zip(surfaces, faces, begin):
        named["ends"] = [start, end]
    return volumes, surfaces


def disc(options):
    z0 = -options.thickness
    z2, z3 = z0 - (HAT_HEIGHT - FLANGE), z0 - HAT_HEIGHT
    volumes, (ring, _, _, _, flange) = turned(
        [(HAT_OUTER, options.ring_outer, z0, 0, options.across, 1),
         (HAT_INNER, HAT_OUTER, z0, 0, 1, 1),
         (HAT_INNER, HAT_OUTER, z2, z0, 1, 2),
         (HAT_INNER, HAT_OUTER, z3, z2, 1, 1),
         (BORE, HAT_INNER, z3, z2, 3, 1)], 0, 2 * math.pi, options.round)
    return volumes, {"top_ring": ring["top"], "bottom_ring": ring["bottom"],
                     "bore": flange["inner"]}


def pad(options, lower):
    """[(volumes, named surfaces)] of lining and plate."""
    angle = math.radians(options.pad_angle) / 2
    z = (0, LINING, LINING + PLATE)
    if lower:
        z = tuple(-options.thickness - value for value in z)
    near, far = ("top", "bottom") if lower else ("bottom", "top")
    parts = []
    for layer, cells in ((0, 2), (1, 1)):
        z0, z1 = sorted((z[layer], z[layer + 1]))
        volumes, (at,) = turned([(PAD_INNER, PAD_OUTER, z0, z1, 3, cells)], -angle, angle,
                                options.along)
        names = ({"face": at[near], "glue": at[far]} if layer == 0 else
                 {"glue": at[near], "back": at[far], "ends": at["ends"]})
        parts.append((volumes, names))
    return parts


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", default="brake.msh")
    parser.add_argument("--ring-outer", type=float, default=0.130, help="radius, m")
    parser.add_argument("--thickness", type=float, default=0.012, help="of the ring, m")
    parser.add_argument("--pad-angle", type=float, default=14, help="degrees")
    parser.add_argument("--round", type=int, default=48, help="cells round the disc")
    parser.add_argument("--across", type=int, default=5, help="cells across the ring")
    parser.add_argument("--along", type=int, default=3, help="cells along a pad")
    options = parser.parse_args()

    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    names = {}
    bodies = [("disc", disc(options))]
    for side in ("upper", "lower"):
        bodies += zip(("lining_" + side, "plate_" + side), pad(options, side == "lower"))
    geo.synchronize()
    for name, (volumes, surfaces) in bodies:
        gmsh.model.addPhysicalGroup(3, volumes, name=name)
        for surface, tags in surfaces.items():
            names.setdefault(surface, []).extend(tags)
    for surface, tags in names.items():
        gmsh.model.addPhysicalGroup(2, tags, name=surface)
    gmsh.model.mesh.generate(3)
    gmsh.model.mesh.setOrder(2)
    # Where the disc has been turned by 360 degrees its two ends become one.
    gmsh.model.mesh.removeDuplicateNodes([(3, volume) for volume in bodies[0][1][0]])
    gmsh.option.setNumber("Mesh.MshFileVersion", 4.1)
    gmsh.write(options.output)
    gmsh.finalize()


main()
