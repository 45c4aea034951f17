#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""check_needles.py WITH.png WITHOUT.png: has the first picture dark needles all over the surface and along its section, which the second has not, and is the
surface seen from obliquely above?"""
import sys

from vtkmodules.vtkIOImage import vtkPNGReader


def pixels(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    values = image.GetPointData().GetScalars()
    return [[tuple(int(c) for c in values.GetTuple(j * width + i)) for i in range(0, width, 2)]
            for j in range(0, height, 2)]


def dark_boxes(picture, columns):
    """Boxes of 25 x 25 pixels in those columns between title and colour bar that have something dark in them."""
    height, width = len(picture), len(picture[0])
    return {(i // 25, j // 25)
            for j in range(int(0.17 * height), int(0.9 * height))
            for i in range(int(columns[0] * width), int(columns[1] * width)) if max(picture[j][i]) < 70}


def main():
    with_needles, without = pixels(sys.argv[1]), pixels(sys.argv[2])
    for name, columns, least in (("surface", (0.0, 0.67), 60), ("section", (0.69, 1.0), 3)):
        more = dark_boxes(with_needles, columns) - dark_boxes(without, columns)
        if len(more) < least:
            sys.exit(f"needles in {len(more)} places of the {name} only")
    height, width = len(without), len(without[0])
    shown = [j for j in range(int(0.17 * height), int(0.9 * height)) if without[j][int(0.34 * width)] != (255, 255, 255)]
    if len(shown) < 0.2 * height:
        sys.exit(f"the surface takes {len(shown)} of {height} lines")


main()
