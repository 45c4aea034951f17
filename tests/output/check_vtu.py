#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""check_vtu.py FILE DEGREE CELLS RADIUS: is FILE, as VTK reads it, a sphere of Lagrange quadrilaterals with its fields?

Exit status 77 when VTK is not installed, 1 with a message when something is wrong.
"""
import math
import sys

try:
    from vtkmodules.vtkCommonDataModel import VTK_LAGRANGE_QUADRILATERAL
    from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
    from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    sys.exit(77)


def check(condition, message):
    if not condition:
        sys.exit("check_vtu.py: " + message)


def main():
    path, degree, n_cells, radius = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), float(sys.argv[4])
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    check(grid.GetNumberOfCells() == n_cells, f"{grid.GetNumberOfCells()} cells")
    for i in range(n_cells):
        check(grid.GetCellType(i) == VTK_LAGRANGE_QUADRILATERAL == 70, f"cell type {grid.GetCellType(i)}")
        check(grid.GetCell(i).GetNumberOfPoints() == (degree + 1) ** 2, "number of points in a cell")

    data = grid.GetPointData()
    position, director = data.GetArray("position"), data.GetArray("director")
    curvature = data.GetArray("mean_curvature_outward")
    check(curvature is not None and curvature.GetNumberOfComponents() == 1, "mean curvature")
    check(position is not None and position.GetNumberOfComponents() == 3, "position")
    check(director is not None and director.GetNumberOfComponents() == 3, "director")
    for i in range(grid.GetNumberOfPoints()):
        x = grid.GetPoint(i)
        check(abs(math.dist(x, (0, 0, 0)) - radius) < 1e-6 * radius, f"point {i} off the sphere")
        check(math.dist(position.GetTuple(i), x) < 1e-6 * radius, f"position at point {i}")
        check(math.dist(director.GetTuple(i), [c / radius for c in x]) < 1e-6, f"director at point {i}")
        check(abs(curvature.GetTuple(i)[0] - 1 / radius) < 1e-5 / radius, f"curvature at point {i}")

    # Between the nodes the cells bulge as they should only if VTK takes the nodes in the order in which they were meant.
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.SetNonlinearSubdivisionLevel(4)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(surface.GetOutputPort())
    mass = vtkMassProperties()
    mass.SetInputConnection(triangles.GetOutputPort())
    mass.Update()
    error = mass.GetSurfaceArea() / (4 * math.pi * radius ** 2) - 1
    bound = {1: 4e-2, 2: 2e-3}.get(degree, 1e-3)
    check(abs(error) < bound, f"relative error of the area {error:.2e}")
    error = mass.GetVolume() / (4 * math.pi * radius ** 3 / 3) - 1
    check(abs(error) < 2 * bound, f"relative error of the volume {error:.2e}")


main()
