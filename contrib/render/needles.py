# SPDX-License-Identifier: LGPL-2.1-or-later
"""Directors as needles: thin cones that stand where they belong and point where the directors point."""
import math
import random

from vtkmodules.vtkCommonCore import vtkFloatArray, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersCore import vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkConeSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

from colours import INK

SLENDERNESS = 0.09  # radius over length


def spread(points, distance):
    """Numbers of points with at least that distance from each other, as dense as they come in a random order: an even
    density whatever the mesh."""
    order = list(range(points.GetNumberOfPoints()))
    random.Random(1).shuffle(order)
    taken, boxes = [], {}
    for i in order:
        x = points.GetPoint(i)
        box = tuple(int(math.floor(c / distance)) for c in x)
        near = (place for a in (-1, 0, 1) for b in (-1, 0, 1) for c in (-1, 0, 1)
                for place in boxes.get((box[0] + a, box[1] + b, box[2] + c), ()))
        if all(math.dist(x, place) >= distance for place in near):
            boxes.setdefault(box, []).append(x)
            taken.append(i)
    return taken


def needles(surface, distance, lift):
    """Needles for the point field `director` of a surface, or of a line on it, about `distance` apart; none if it has
    no such field. They begin at a height `lift`, so that those that lie in the surface do not sink into it."""
    directors, normals = surface.GetPointData().GetArray("director"), surface.GetPointData().GetNormals()
    if directors is None:
        return None
    places, vectors = vtkPoints(), vtkFloatArray()
    vectors.SetNumberOfComponents(3)
    for i in spread(surface, distance):
        n = normals.GetTuple(i) if normals is not None else (0, 0, 0)
        places.InsertNextPoint(*(x + lift * c for x, c in zip(surface.GetPoint(i), n)))
        vectors.InsertNextTuple(directors.GetTuple(i))
    chosen = vtkPolyData()
    chosen.SetPoints(places)
    chosen.GetPointData().SetVectors(vectors)

    cone = vtkConeSource()
    cone.SetHeight(1)
    cone.SetRadius(SLENDERNESS)
    cone.SetCenter(0.5, 0, 0)
    cone.SetResolution(10)
    glyphs = vtkGlyph3D()
    glyphs.SetInputData(chosen)
    glyphs.SetSourceConnection(cone.GetOutputPort())
    glyphs.SetVectorModeToUseVector()
    glyphs.SetScaleModeToScaleByVector()
    glyphs.SetScaleFactor(distance)
    glyphs.Update()
    return glyphs.GetOutput()


def needle_actor(needles_to_draw):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(needles_to_draw)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*INK)
    look.SetAmbient(0.4)
    look.SetDiffuse(0.6)
    return actor
