# SPDX-License-Identifier: LGPL-2.1-or-later
"""A pad of 10 x 10 x 10 mm with a chamfer of 2 mm at its two ends along y, as a Gmsh file.

Its working face is `face`, its back `back`; lengths in metres, Gmsh format 2.2.
"""
NX, NY, NZ = 3, 5, 3          # cells along x, y and z
SIZE, CHAMFER = 0.010, 0.002


def y_of(j, k):
    """Ends of the face come in by the chamfer; the back is as long as the pad."""
    half = SIZE / 2 - CHAMFER * (1 - k / NZ)
    return -half + 2 * half * j / NY


def number(i, j, k):
    return 1 + i + (NX + 1) * (j + (NY + 1) * k)


lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat",
         "$PhysicalNames", "3", '2 1 "face"', '2 2 "back"', '3 3 "pad"',
         "$EndPhysicalNames", "$Nodes", str((NX + 1) * (NY + 1) * (NZ + 1))]
for k in range(NZ + 1):
    for j in range(NY + 1):
        for i in range(NX + 1):
            x = SIZE * (i / NX - 0.5)
            lines.append("%d %.9g %.9g %.9g"
                         % (number(i, j, k), x, y_of(j, k), SIZE * k / NZ))
elements = []
for k, tag in ((0, 1), (NZ, 2)):
    for j in range(NY):
        for i in range(NX):
            elements.append((3, tag, [number(i, j, k), number(i + 1, j, k),
                                      number(i + 1, j + 1, k), number(i, j + 1, k)]))
for k in range(NZ):
    for j in range(NY):
        for i in range(NX):
            corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
            elements.append((5, 3, [number(a, b, k) for a, b in corners]
                             + [number(a, b, k + 1) for a, b in corners]))
lines += ["$EndNodes", "$Elements", str(len(elements))]
for n, (kind, tag, nodes) in enumerate(elements, 1):
    lines.append(" ".join(str(v) for v in [n, kind, 2, tag, tag] + nodes))
lines.append("$EndElements")
with open("pad.msh", "w", encoding="ascii") as mesh:
    mesh.write("\n".join(lines) + "\n")
