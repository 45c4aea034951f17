#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Writes prm/hard/thin_cells.msh: a prolate spheroid of reduced volume 0.9 from the six sides of a cube, cut so that cells are
up to twenty times as long as wide.

    python3 contrib/hard_cases/thin_cells.py > prm/hard/thin_cells.msh

Each side of the cube is cut into AROUND strips around z. Along z there are ALONG of them, narrow in the middle and RATIO times as
wide from one to the next.
"""

import math

HALF_AXES = (0.7384, 0.7384, 1.4293)
AROUND, ALONG, RATIO = 4, 8, 3.9


def narrow_in_the_middle():
    """Places of the cuts in [-1, 1]."""
    widths = [RATIO ** abs(i - (ALONG - 1) / 2) for i in range(ALONG)]
    places = [0.0]
    for width in widths:
        places.append(places[-1] + width)
    return [2 * place / places[-1] - 1 for place in places]


def on_spheroid(point):
    """Of a point of the cube: the sphere's point with tan of the angles as coordinates, stretched to the half axes."""
    direction = [math.tan(math.pi / 4 * x) for x in point]
    length = math.sqrt(sum(x * x for x in direction))
    return tuple(a * x / length for a, x in zip(HALF_AXES, direction))


def grid():
    """Nodes and quadrilaterals. z is cut narrowly on the four sides; the top and bottom are cut evenly."""
    even, narrow = [2 * i / AROUND - 1 for i in range(AROUND + 1)], narrow_in_the_middle()
    numbers, nodes, cells = {}, [], []

    def node(point):
        key = tuple(round(x, 9) for x in point)
        if key not in numbers:
            numbers[key] = len(nodes) + 1
            nodes.append(on_spheroid(point))
        return numbers[key]

    def side(place, u_cuts, v_cuts):
        for i in range(len(u_cuts) - 1):
            for j in range(len(v_cuts) - 1):
                corners = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
                cells.append([node(place(u_cuts[a], v_cuts[b])) for a, b in corners])

    side(lambda u, v: (1, u, v), even, narrow)
    side(lambda u, v: (-1, -u, v), even, narrow)
    side(lambda u, v: (-u, 1, v), even, narrow)
    side(lambda u, v: (u, -1, v), even, narrow)
    side(lambda u, v: (u, v, 1), even, even)
    side(lambda u, v: (u, -v, -1), even, even)
    return nodes, cells


def main():
    nodes, cells = grid()
    print("$MeshFormat\n4.1 0 8\n$EndMeshFormat")
    print(f"$Nodes\n1 {len(nodes)} 1 {len(nodes)}\n2 1 0 {len(nodes)}")
    print("\n".join(str(i + 1) for i in range(len(nodes))))
    print("\n".join(" ".join(f"{x:.9g}" for x in node) for node in nodes))
    print(f"$EndNodes\n$Elements\n1 {len(cells)} 1 {len(cells)}\n2 1 3 {len(cells)}")
    print("\n".join(f"{i + 1} " + " ".join(map(str, cell)) for i, cell in enumerate(cells)))
    print("$EndElements")


if __name__ == "__main__":
    main()
