#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""check_hexahedra.py FILE DEGREE CELLS VOLUME: is FILE, as VTK reads it, the deformed unit block of vtu.cc in Lagrange hexahedra?

Exit status 77 when VTK is not installed, 1 with a message when something is wrong.
"""
import math
import sys

try:
    from vtkmodules.vtkCommonCore import reference
    from vtkmodules.vtkCommonDataModel import VTK_LAGRANGE_HEXAHEDRON
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    sys.exit(77)


def check(condition, message):
    if not condition:
        sys.exit("check_hexahedra.py: " + message)


def gauss(n):
    """Points and weights on [0, 1] for n = 4."""
    assert n == 4
    a, b = math.sqrt(3 / 7 - 2 / 7 * math.sqrt(6 / 5)), math.sqrt(3 / 7 + 2 / 7 * math.sqrt(6 / 5))
    u, v = (18 + math.sqrt(30)) / 72, (18 - math.sqrt(30)) / 72
    return [((1 - b) / 2, v), ((1 - a) / 2, u), ((1 + a) / 2, u), ((1 + b) / 2, v)]


def main():
    path, degree, n_cells, volume = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), float(sys.argv[4])
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    n_points = (degree + 1) ** 3
    check(grid.GetNumberOfCells() == n_cells, f"{grid.GetNumberOfCells()} cells")
    material, tensor = grid.GetPointData().GetArray("material_position"), grid.GetPointData().GetArray("cauchy_stress")
    check(material is not None and material.GetNumberOfComponents() == 3, "material position")
    check(tensor is not None and tensor.GetNumberOfComponents() == 9, "stress")
    for i in range(grid.GetNumberOfPoints()):
        check(tensor.GetTuple(i) == tuple(float(c) for c in range(9)), f"stress at point {i}")

    total, lines = 0.0, gauss(4)
    for c in range(n_cells):
        cell = grid.GetCell(c)
        check(grid.GetCellType(c) == VTK_LAGRANGE_HEXAHEDRON == 72, f"cell type {grid.GetCellType(c)}")
        check(cell.GetNumberOfPoints() == n_points, "number of points in a cell")

        def at(p, values):
            weights, place = [0.0] * n_points, [0.0] * 3
            cell.EvaluateLocation(reference(0), p, place, weights)
            if values is None:
                return place
            return [sum(w * values.GetTuple(cell.GetPointId(i))[k] for i, w in enumerate(weights)) for k in range(3)]

        low, high = at((0, 0, 0), material), at((1, 1, 1), material)
        for x, wx in lines:
            for y, wy in lines:
                for z, wz in lines:
                    # Undeformed, a cell is a box: material places are linear only if the points are in VTK's order.
                    X = at((x, y, z), material)
                    check(math.dist(X, [a + t * (b - a) for a, b, t in zip(low, high, (x, y, z))]) < 1e-6, f"material place in cell {c}")
                    here, h, columns = at((x, y, z), None), 1e-2, []
                    for d in range(3):
                        steps = [[t + s * h * (k == d) for k, t in enumerate((x, y, z))] for s in (-1, 1)]
                        columns.append([(b - a) / (2 * h) for a, b in zip(*(at(p, None) for p in steps))])
                    (a, b, e), (f, g, i), (j, k, m) = columns
                    total += wx * wy * wz * (a * (g * m - i * k) - b * (f * m - i * j) + e * (f * k - g * j))
                    bent = X[0] + 0.2 * X[1] ** degree, X[1], X[2] * (1 + 0.3 * X[0])
                    if degree >= 2:
                        check(math.dist(here, bent) < 1e-6, f"place in cell {c}: {here} instead of {bent}")
    check(abs(total / volume - 1) < 1e-3, f"volume {total}")


main()
