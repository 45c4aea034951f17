#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""check_director_fields.py FILE.vtu: on a unit sphere, are there directors with norm 1, and is `tilt` their tangential part?

Exit status 77 when VTK is not installed, 1 with a message when something is wrong.
"""
import math
import sys

try:
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError:
    sys.exit(77)


def main():
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(sys.argv[1])
    reader.Update()
    grid = reader.GetOutput()
    director, tilt = (grid.GetPointData().GetArray(name) for name in ("director", "tilt"))
    for name, array in (("director", director), ("tilt", tilt)):
        if array is None or array.GetNumberOfComponents() != 3:
            sys.exit(f"no vector field '{name}'")
    if grid.GetNumberOfPoints() == 0:
        sys.exit("no points")
    longest = 0.0
    for i in range(grid.GetNumberOfPoints()):
        n, O, t = grid.GetPoint(i), director.GetTuple(i), tilt.GetTuple(i)
        along = sum(a * b for a, b in zip(O, n))
        # Exact at nodes; between them both are interpolated.
        if abs(math.hypot(*O) - 1) > 0.02:
            sys.exit(f"|O| = {math.hypot(*O)} at {n}")
        if math.dist(t, [a - along * b for a, b in zip(O, n)]) > 0.02:
            sys.exit(f"tilt {t} of the director {O} at {n}")
        longest = max(longest, math.hypot(*t))
    print(longest)


main()
