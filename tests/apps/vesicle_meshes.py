# SPDX-License-Identifier: LGPL-2.1-or-later
"""Small Gmsh files (MSH 4.1, ASCII)."""

from itertools import product


def msh_text(nodes, cells):
    """Nodes are points, cells are lists of three or four numbers of nodes from 0."""
    lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$Nodes", f"1 {len(nodes)} 1 {len(nodes)}", f"2 1 0 {len(nodes)}"]
    lines += [str(tag + 1) for tag in range(len(nodes))]
    lines += [" ".join(repr(float(x)) for x in node) for node in nodes]
    lines += ["$EndNodes", "$Elements"]
    kinds = [n for n in (3, 4) if any(len(cell) == n for cell in cells)]
    lines.append(f"{len(kinds)} {len(cells)} 1 {len(cells)}")
    tag = 0
    for n in kinds:
        of_kind = [cell for cell in cells if len(cell) == n]
        lines.append(f"2 1 {n - 1} {len(of_kind)}")
        for cell in of_kind:
            tag += 1
            lines.append(" ".join(str(number) for number in (tag, *(v + 1 for v in cell))))
    return "\n".join([*lines, "$EndElements", ""])


def box(lengths, cuts=2):
    """Surface of a box, cuts x cuts facets a side, outward."""
    nodes, numbers, cells = [], {}, []

    def number(point):
        if point not in numbers:
            numbers[point] = len(nodes)
            nodes.append([length * (p / cuts - 0.5) for p, length in zip(point, lengths)])
        return numbers[point]

    for axis, side in product(range(3), (0, cuts)):
        for i, j in product(range(cuts), repeat=2):
            corners = []
            for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                point = [0, 0, 0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = side, i + di, j + dj
                corners.append(number(tuple(point)))
            cells.append(corners if side else corners[::-1])
    return nodes, cells


def spheroid(stretch, cuts=2):
    """The facets of a cube, their nodes on the unit sphere stretched in z."""
    nodes, cells = box((2.0, 2.0, 2.0), cuts)
    projected = []
    for x, y, z in nodes:
        r = (x * x + y * y + z * z) ** 0.5
        projected.append((x / r, y / r, stretch * z / r))
    return projected, cells


def projective_plane():
    """The six-vertex triangulation: every edge has two triangles, and there is no inside."""
    nodes = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0.2, 0), (0, -1, 0.3), (0.4, 0, -1)]
    triangles = ["123", "124", "135", "146", "156", "236", "245", "256", "345", "346"]
    return nodes, [[int(v) - 1 for v in triangle] for triangle in triangles]


def grid_on_a_wrapped_square(n, flip):
    """n x n quadrilaterals whose sides are glued: a torus, or with flip a Klein bottle (immersed in space, it passes through itself)."""
    from math import cos, pi, sin

    def number(i, j):
        if i == n and flip:
            j = -j
        return (i % n) * n + j % n

    nodes = []
    for i, j in product(range(n), repeat=2):
        u, v = 2 * pi * i / n, 2 * pi * j / n
        if flip:
            r = 3 + cos(u / 2) * sin(v) - sin(u / 2) * sin(2 * v)
            nodes.append((r * cos(u), r * sin(u), sin(u / 2) * sin(v) + cos(u / 2) * sin(2 * v)))
        else:
            nodes.append(((3 + cos(v)) * cos(u), (3 + cos(v)) * sin(u), sin(v)))
    cells = [[number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)] for i, j in product(range(n), repeat=2)]
    return nodes, cells
