#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws a surface from a high-order VTU file into a PNG file, coloured by one of its fields.

    xvfb-run -a /usr/bin/python3 render_surface.py solution_0004.vtu picture.png [--field FIELD] [--title TEXT]
        [--beside substrate.vtu]

The field is mean_curvature_outward unless said otherwise, or the length of the field tilt where a surface with directors
is a plane or a sphere. Left: the surface in three-quarter view, from the side that shows the deeper dimple. Right: its
section by the x-z plane through the centre, in the same colours. The field director is drawn as needles. Below: the
colour bar. What is in the file beside is drawn in grey: bodies that the surface touches. Needs the Debian packages
python3-vtk9, xvfb and xauth; nothing else. Exit status: 0 picture written; 1 the file cannot be drawn; 3 VTK is not
installed. The last line printed says why.
"""
import argparse
import math
import os
import sys

try:
    import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws text)
    import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  (draws everything else)
    from vtkmodules.vtkCommonCore import vtkOutputWindow
    from vtkmodules.vtkCommonDataModel import vtkPlane
    from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
    from vtkmodules.vtkFiltersCore import (vtkArrayCalculator, vtkCutter, vtkMassProperties, vtkPolyDataNormals,
                                           vtkStaticCleanPolyData, vtkStripper, vtkTriangleFilter, vtkTubeFilter)
    from vtkmodules.vtkFiltersGeneral import vtkContourTriangulator
    from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
    from vtkmodules.vtkIOImage import vtkPNGWriter
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper,
                                             vtkRenderer, vtkRenderWindow, vtkTextActor, vtkWindowToImageFilter)

    from colours import CONSTANT, INK, CannotDraw, colour_bar, colour_map, colour_range, percentiles
    from needles import needle_actor, needles
except ImportError as error:
    print(f"VTK for Python is missing ({error}; on Debian: apt-get install python3-vtk9).", file=sys.stderr)
    sys.exit(3)

WIDTH, HEIGHT = 1400, 1050
MAIN_VIEW = (0.0, 0.16, 0.68, 0.92)  # left, bottom, right, top as parts of the picture
SECTION_VIEW = (0.68, 0.30, 1.0, 0.84)
STONE = (0.55, 0.56, 0.58)
TITLES = {"mean_curvature_outward": "Mean curvature (positive on a sphere)", "gauss_curvature": "Gauss curvature",
          "tilt_length": "Tilt, the length of the directors' tangential part"}
NEEDLES = 28  # along the side of a square of the surface's area


def read_surface(path, field):
    """The triangles that stand for the surface in the picture, and the scalar field for their colours: the one that is
    asked for, or one that suits the surface."""
    if not os.path.isfile(path):
        raise CannotDraw(f"{path} does not exist.")
    vtkOutputWindow.SetGlobalWarningDisplay(0)  # VTK's own complaints about a broken file say less than ours
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    if reader.GetErrorCode() != 0 or grid.GetNumberOfCells() == 0:
        raise CannotDraw(f"{path} holds no surface.")
    wanted = field or "mean_curvature_outward"
    array = grid.GetPointData().GetArray(wanted)
    if array is None or array.GetNumberOfComponents() != 1:
        names = [grid.GetPointData().GetArrayName(i) for i in range(grid.GetPointData().GetNumberOfArrays())]
        raise CannotDraw(f"{path} has no scalar field '{wanted}' (it has {', '.join(map(str, names))}).")

    # Each step of the subdivision quadruples the triangles; a few hundred thousand show no facets at this size.
    nodes_per_cell = grid.GetNumberOfPoints() / grid.GetNumberOfCells()
    triangles_per_cell = 2 * (math.sqrt(nodes_per_cell) - 1) ** 2
    level = 4
    while level > 1 and grid.GetNumberOfCells() * triangles_per_cell * 4 ** (level - 1) > 400000:
        level -= 1
    facets = vtkDataSetSurfaceFilter()
    facets.SetInputData(grid)
    facets.SetNonlinearSubdivisionLevel(level)
    triangles = vtkTriangleFilter()
    triangles.SetInputConnection(facets.GetOutputPort())
    # Cells repeat the points they share; joined, they get one normal, and no crease shows between cells.
    joined = vtkStaticCleanPolyData()
    joined.SetInputConnection(triangles.GetOutputPort())
    joined.ToleranceIsAbsoluteOn()
    joined.SetAbsoluteTolerance(2e-6 * grid.GetLength())  # coordinates have single precision
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(joined.GetOutputPort())
    normals.SplittingOff()
    normals.ConsistencyOff()
    lengths = vtkArrayCalculator()
    lengths.SetInputConnection(normals.GetOutputPort())
    lengths.AddVectorArrayName("tilt")
    lengths.SetFunction("mag(tilt)")
    lengths.SetResultArrayName("tilt_length")
    last = normals if grid.GetPointData().GetArray("tilt") is None else lengths
    last.Update()
    surface = last.GetOutput()
    field = field or chosen_field(surface)
    surface.GetPointData().SetActiveScalars(field)
    return surface, field


def chosen_field(surface):
    """What tells most about a surface: of directors on a plane or a sphere the tilt, else curvature."""
    curvature = "mean_curvature_outward"
    if surface.GetPointData().GetArray("tilt_length") is None:
        return curvature
    low, high = percentiles(surface, curvature)
    size = max(box_of(surface)[1])
    return "tilt_length" if high - low < CONSTANT * max(abs(low), abs(high), 0.1 / size) else curvature


def coloured_actor(algorithm, colours):
    """An actor for what a filter gives, with the colours of its active scalars."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(algorithm.GetOutputPort())
    mapper.SetLookupTable(colours)
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def camera_side(surface):
    """+1 to look from above, -1 from below: the side of the deeper dimple about the vertical axis."""
    centre, size = box_of(surface)
    low, high = surface.GetBounds()[4:6]
    radius = max(size[0], size[1]) / 2
    heights = []
    points = surface.GetPoints()
    for i in range(points.GetNumberOfPoints()):
        x, y, z = points.GetPoint(i)
        if math.hypot(x - centre[0], y - centre[1]) < 0.1 * radius:
            heights.append(z)
    if not heights:
        return 1
    return 1 if high - max(heights) >= min(heights) - low - 1e-3 * (high - low) else -1


def box_of(surface):
    """Centre and size of the bounding box."""
    bounds = surface.GetBounds()
    low, high = bounds[0::2], bounds[1::2]
    return [(a + b) / 2 for a, b in zip(low, high)], [b - a for a, b in zip(low, high)]


def facets_of(path):
    """Triangles of a VTU file without colours, with normals."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    facets = vtkDataSetSurfaceFilter()
    facets.SetInputConnection(reader.GetOutputPort())
    facets.SetNonlinearSubdivisionLevel(1)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(facets.GetOutputPort())
    normals.SplittingOff()
    normals.Update()
    if normals.GetOutput().GetNumberOfCells() == 0:
        raise CannotDraw(f"{path} holds no surface.")
    return normals.GetOutput()


def grey_actor(algorithm, opacity):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(algorithm.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*STONE)
    actor.GetProperty().SetOpacity(opacity)
    return actor


def needle_distance(surface):
    mass = vtkMassProperties()
    mass.SetInputData(surface)
    mass.Update()
    return math.sqrt(mass.GetSurfaceArea()) / NEEDLES


def main_view(surface, colours, beside):
    """The shaded surface."""
    centre, size = box_of(surface)
    renderer = vtkRenderer()
    renderer.SetViewport(*MAIN_VIEW)
    renderer.SetBackground(1, 1, 1)
    producer = vtkTrivialProducer()
    producer.SetOutput(surface)
    actor = coloured_actor(producer, colours)
    look = actor.GetProperty()
    look.SetInterpolationToPhong()
    look.SetAmbient(0.36)
    look.SetDiffuse(0.78)
    look.SetSpecular(0.22)
    look.SetSpecularPower(28)
    renderer.AddActor(actor)
    drawn = [surface] if beside is None else [surface, beside]
    distance = needle_distance(surface)
    directors = needles(surface, distance, 0.09 * distance)
    if directors is not None:
        renderer.AddActor(needle_actor(directors))
        drawn.append(directors)
    if beside is not None:
        bodies = vtkTrivialProducer()
        bodies.SetOutput(beside)
        renderer.AddActor(grey_actor(bodies, 0.35))

    # Tall shapes are seen from the side, flat ones from well above, where their dimples show.
    flatness = max(size[0], size[1]) / max(size[2], 1e-300)
    elevation = math.radians(18 if flatness < 0.9 or beside is not None else 38)
    if beside is None:  # what lies on a body is not seen from below
        elevation *= camera_side(surface)
    azimuth = math.radians(-60)
    direction = (math.cos(elevation) * math.cos(azimuth), math.cos(elevation) * math.sin(azimuth), math.sin(elevation))
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(c + d for c, d in zip(centre, direction)))
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(22)
    renderer.ResetCamera()
    fill_view(renderer, drawn)

    renderer.AutomaticLightCreationOff()
    key, fill = ((-0.9, 1.3, 1.4), 0.78, (1.0, 0.985, 0.96)), ((1.6, 0.2, 1.0), 0.30, (0.93, 0.96, 1.0))
    from_below = ((-0.4, -1.4, 0.6), 0.16, (1.0, 1.0, 1.0)), ((0.1, -1.6, -0.3), 0.22, (1.0, 1.0, 1.0))
    for position, strength, tint in (key, fill, *from_below):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetFocalPoint(0, 0, 0)
        light.SetIntensity(strength)
        light.SetColor(*tint)
        renderer.AddLight(light)
    return renderer


def fill_view(renderer, surfaces, view=MAIN_VIEW):
    """Moves the camera's window so that the surfaces, not their bounding sphere, fill the view."""
    camera = renderer.GetActiveCamera()
    aspect = view_aspect(view)
    matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1)
    xs, ys = [], []
    for points in (surface.GetPoints() for surface in surfaces):
        for i in range(0, points.GetNumberOfPoints(), max(1, points.GetNumberOfPoints() // 5000)):
            x, y, _, w = matrix.MultiplyPoint((*points.GetPoint(i), 1.0))
            xs.append(x / w)
            ys.append(y / w)
    camera.SetWindowCenter((min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2)
    extent = max(max(xs) - min(xs), max(ys) - min(ys)) / 2
    angle = math.radians(camera.GetViewAngle() / 2)
    camera.SetViewAngle(2 * math.degrees(math.atan(math.tan(angle) * extent / 0.90)))
    # The window's centre is measured in half widths of the view, which have just changed.
    cx, cy = camera.GetWindowCenter()
    camera.SetWindowCenter(cx * 0.90 / extent, cy * 0.90 / extent)
    renderer.ResetCameraClippingRange()


def view_aspect(view):
    return (view[2] - view[0]) * WIDTH / ((view[3] - view[1]) * HEIGHT)


def section_half_height(size):
    """Half the height of what the section's view shows, in the surface's units: the section fills 86 % of it."""
    return max(size[2] / 2, size[0] / 2 / view_aspect(SECTION_VIEW)) / 0.86


def all_closed(lines):
    """Whether every polyline ends where it begins."""
    return all(line.GetPointId(0) == line.GetPointId(line.GetNumberOfPoints() - 1)
               for line in (lines.GetCell(i) for i in range(lines.GetNumberOfCells())))


def section_view(surface, colours, beside):
    """The section by the plane y = const through the centre: a coloured line about a light grey inside."""
    centre, size = box_of(surface)
    plane = vtkPlane()
    # Slightly off the centre, where meshes like to have corners: a cut through a corner gives points twice.
    plane.SetOrigin(centre[0], centre[1] + 3.7e-4 * size[1], centre[2])
    plane.SetNormal(0, 1, 0)
    cutter = vtkCutter()
    cutter.SetInputData(surface)
    cutter.SetCutFunction(plane)
    lines = vtkStripper()
    lines.SetInputConnection(cutter.GetOutputPort())
    lines.JoinContiguousSegmentsOn()
    lines.SetMaximumLength(1000000)

    renderer = vtkRenderer()
    renderer.SetViewport(*SECTION_VIEW)
    renderer.SetBackground(1, 1, 1)
    lines.Update()
    if all_closed(lines.GetOutput()):  # the section of an open surface has no inside
        inside = vtkContourTriangulator()
        inside.SetInputConnection(lines.GetOutputPort())
        filling = vtkPolyDataMapper()
        filling.SetInputConnection(inside.GetOutputPort())
        filling.ScalarVisibilityOff()
        filled = vtkActor()
        filled.SetMapper(filling)
        filled.GetProperty().SetColor(0.94, 0.945, 0.955)
        filled.GetProperty().LightingOff()
        renderer.AddActor(filled)

    tube = vtkTubeFilter()
    tube.SetInputConnection(lines.GetOutputPort())
    half_height = section_half_height(size)
    tube.SetRadius(0.015 * half_height)
    tube.SetNumberOfSides(16)
    tube.UseDefaultNormalOn()  # the line is plane
    tube.SetDefaultNormal(0, 1, 0)
    outline = coloured_actor(tube, colours)
    outline.GetProperty().LightingOff()
    renderer.AddActor(outline)

    directors = needles(lines.GetOutput(), 0.09 * half_height, 0.015 * half_height)
    if directors is not None:
        renderer.AddActor(needle_actor(directors))

    if beside is not None:
        through = vtkCutter()
        through.SetInputData(beside)
        through.SetCutFunction(plane)
        wall = vtkTubeFilter()
        wall.SetInputConnection(through.GetOutputPort())
        wall.SetRadius(0.009 * half_height)
        wall.SetNumberOfSides(8)
        body = grey_actor(wall, 1)
        body.GetProperty().LightingOff()
        renderer.AddActor(body)

    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(*centre)
    camera.SetPosition(centre[0], centre[1] - 10 * max(size), centre[2])
    camera.SetViewUp(0, 0, 1)
    camera.SetParallelScale(half_height)
    renderer.ResetCameraClippingRange()
    return renderer


def text(content, x, y, size, bold=False):
    """Centred text at (x, y), as parts of the picture."""
    actor = vtkTextActor()
    actor.SetInput(content)
    actor.GetPositionCoordinate().SetCoordinateSystemToNormalizedDisplay()
    actor.SetPosition(x, y)
    style = actor.GetTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(size)
    style.SetBold(bold)
    style.SetColor(*INK)
    style.SetJustificationToCentered()
    style.SetVerticalJustificationToCentered()
    return actor


def white_window():
    """White paper below, for views to stand on; text and colour bar go on a transparent layer above."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(WIDTH, HEIGHT)
    window.SetNumberOfLayers(2)
    paper = vtkRenderer()
    paper.SetBackground(1, 1, 1)
    window.AddRenderer(paper)
    return window


def draw(surface, field, title, beside):
    """The render window with everything in it."""
    low, high = colour_range(surface, field)
    colours = colour_map(low, high, field)
    window = white_window()
    for view in (main_view(surface, colours, beside), section_view(surface, colours, beside)):
        window.AddRenderer(view)
    page = vtkRenderer()
    page.SetLayer(1)
    page.AddViewProp(text(title, 0.5, 0.955, 34, bold=True))
    size = box_of(surface)[1]
    left, bottom, right, top = SECTION_VIEW
    lower_edge = (bottom + top) / 2 - (top - bottom) / 2 * size[2] / 2 / section_half_height(size)
    page.AddViewProp(text("Section by the x-z plane", (left + right) / 2, lower_edge - 0.055, 22))
    page.AddViewProp(text(TITLES.get(field, field.replace("_", " ")), 0.5, 0.125, 24))
    page.AddViewProp(colour_bar(colours, low, high))
    window.AddRenderer(page)
    return window


def write_picture(window, path):
    """Whole or not at all: to a temporary name, then renamed."""
    grabber = vtkWindowToImageFilter()
    grabber.SetInput(window)
    grabber.SetInputBufferTypeToRGB()
    grabber.ReadFrontBufferOff()
    grabber.ShouldRerenderOff()
    temporary = path + ".tmp"
    writer = vtkPNGWriter()
    writer.SetFileName(temporary)
    writer.SetInputConnection(grabber.GetOutputPort())
    window.Render()
    writer.Write()
    if writer.GetErrorCode() != 0 or not os.path.isfile(temporary) or os.path.getsize(temporary) == 0:
        if os.path.isfile(temporary):
            os.remove(temporary)
        raise CannotDraw(f"{path} cannot be written.")
    os.replace(temporary, path)


def main():
    parser = argparse.ArgumentParser(description="Draws a surface from a high-order VTU file into a PNG file.")
    parser.add_argument("vtu")
    parser.add_argument("png")
    parser.add_argument("--field", default="", help="scalar point field that gives the colours")
    parser.add_argument("--title", default="")
    parser.add_argument("--beside", default="", help="VTU file of bodies to be drawn in grey")
    arguments = parser.parse_args()
    try:
        beside = facets_of(arguments.beside) if arguments.beside else None
        surface, field = read_surface(arguments.vtu, arguments.field)
        write_picture(draw(surface, field, arguments.title, beside), arguments.png)
    except CannotDraw as error:
        print(error, file=sys.stderr)
        sys.exit(1)


if __name__ == "__main__":
    main()
