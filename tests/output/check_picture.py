#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""check_picture.py FILE.png: is it a picture of the right size, mostly white at the rim, with a shaded surface in many colours?"""
import sys

from vtkmodules.vtkIOImage import vtkPNGReader


def main():
    reader = vtkPNGReader()
    reader.SetFileName(sys.argv[1])
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    if (width, height) != (1400, 1050):
        sys.exit(f"the picture has {width} x {height} pixels")
    values = image.GetPointData().GetScalars()
    colour = lambda i, j: tuple(int(c) for c in values.GetTuple(j * width + i))
    for corner in (colour(0, 0), colour(width - 1, 0), colour(0, height - 1), colour(width - 1, height - 1)):
        if corner != (255, 255, 255):
            sys.exit(f"a corner has the colour {corner} instead of white")
    colours = {colour(i, j) for j in range(0, height, 10) for i in range(0, width, 10)}
    if len(colours) < 200:
        sys.exit(f"only {len(colours)} colours")
    # The rim of a biconcave cell is curved outward (red), its dimples inward (blue).
    red = sum(1 for c in colours if c[0] > c[2] + 30)
    blue = sum(1 for c in colours if c[2] > c[0] + 30)
    if red < 20 or blue < 20:
        sys.exit(f"{red} reds and {blue} blues: the curvature is not shown")


main()
