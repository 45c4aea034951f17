#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Draws a drop on a deformable body in section, from high-order VTU files into a PNG file.

    xvfb-run -a /usr/bin/python3 render_section.py solution_0004.vtu substrate_0004.vtu picture.png [--field FIELD] [--title TEXT]

Top: the section by the x-z plane, the body in the colours of a field (vertical displacement unless said otherwise; a name, or NAME:COMPONENT) with
the lines of its mesh, the drop's profile and the undeformed top. Below, left: the neighbourhood of the contact line, enlarged. Right: the whole in
space. The body is given by hexahedra, or by the quadrilaterals of its half section if all is axisymmetric. Needs what render_surface.py needs, and
ends as it does.
"""
import argparse
import math
import os
import sys

from render_surface import all_closed, box_of, coloured_actor, fill_view, grey_actor, text, view_aspect, white_window, write_picture

from colours import INK, CannotDraw, colour_bar, colour_map, colour_range

try:
    from vtkmodules.vtkCommonCore import reference, vtkDoubleArray, vtkPoints
    from vtkmodules.vtkCommonDataModel import (VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_QUADRILATERAL, vtkCellArray, vtkPlane, vtkPolyData,
                                               vtkUnstructuredGrid)
    from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
    from vtkmodules.vtkCommonTransforms import vtkTransform
    from vtkmodules.vtkFiltersCore import (vtkAppendPolyData, vtkCleanPolyData, vtkCutter, vtkPolyDataNormals, vtkStripper,
                                           vtkThreshold)
    from vtkmodules.vtkFiltersGeneral import vtkContourTriangulator, vtkTransformPolyDataFilter
    from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    from vtkmodules.vtkRenderingCore import vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer
except ImportError as error:
    print(f"VTK for Python is missing ({error}; on Debian: apt-get install python3-vtk9).", file=sys.stderr)
    sys.exit(3)

MAIN_VIEW = (0.02, 0.52, 0.98, 0.93)  # left, bottom, right, top as parts of the picture
ZOOM_VIEW = (0.04, 0.15, 0.49, 0.50)
SPACE_VIEW = (0.52, 0.14, 0.99, 0.50)
LIQUID, DROP_LINE, MESH_LINE = (0.87, 0.93, 0.98), (0.10, 0.30, 0.55), (0.12, 0.13, 0.16)
CAP, WETTED, DRY = range(3)  # regions of the surface
TITLES = {"displacement:2": "Vertical displacement", "volume_ratio": "Volume ratio J", "von_mises_stress": "Von Mises stress",
          "mean_pressure": "Mean pressure", "elastic_energy_density": "Elastic energy per reference volume"}


def read_grid(path):
    if not os.path.isfile(path):
        raise CannotDraw(f"{path} does not exist.")
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    if reader.GetErrorCode() != 0 or grid.GetNumberOfCells() == 0:
        raise CannotDraw(f"{path} holds no cells.")
    return grid


def component_of(grid, field):
    """Adds the scalar field to the points, as "shown"."""
    name, _, component = field.partition(":")
    array = grid.GetPointData().GetArray(name)
    if array is None or (array.GetNumberOfComponents() > 1) != bool(component):
        names = [grid.GetPointData().GetArrayName(i) for i in range(grid.GetPointData().GetNumberOfArrays())]
        raise CannotDraw(f"there is no scalar field '{field}' (there are {', '.join(map(str, names))}).")
    shown = vtkDoubleArray()
    shown.SetName("shown")
    for i in range(array.GetNumberOfTuples()):
        shown.InsertNextValue(array.GetTuple(i)[int(component or 0)])
    grid.GetPointData().AddArray(shown)
    grid.GetPointData().SetActiveScalars("shown")


def section_cells(grid):
    """The quadrilaterals of the section y = 0: all cells, or the faces of hexahedra that lay there undeformed."""
    if grid.GetCellType(0) != VTK_LAGRANGE_HEXAHEDRON:
        return grid
    material = grid.GetPointData().GetArray("material_position")
    if material is None:
        raise CannotDraw("the body has no field 'material_position'.")
    tolerance = 1e-5 * grid.GetLength()
    section = vtkUnstructuredGrid()
    section.SetPoints(grid.GetPoints())
    section.GetPointData().ShallowCopy(grid.GetPointData())
    for c in range(grid.GetNumberOfCells()):
        cell = grid.GetCell(c)
        if all(abs(material.GetTuple(cell.GetPointId(i))[1]) > tolerance for i in range(8)):
            continue
        for f in range(6):
            ids = cell.GetFace(f).GetPointIds()
            if all(abs(material.GetTuple(ids.GetId(i))[1]) < tolerance for i in range(ids.GetNumberOfIds())):
                section.InsertNextCell(VTK_LAGRANGE_QUADRILATERAL, ids)
    if section.GetNumberOfCells() == 0:
        raise CannotDraw("the body has no cells along the plane y = 0.")
    return section


def facets(grid, level):
    """Triangles of high-order cells."""
    fine = vtkDataSetSurfaceFilter()
    fine.SetInputData(grid)
    fine.SetNonlinearSubdivisionLevel(level)
    fine.Update()
    return fine.GetOutput()


def mesh_lines(section):
    """The edges of the quadrilaterals as polylines."""
    points, lines = vtkPoints(), vtkCellArray()
    for c in range(section.GetNumberOfCells()):
        cell = section.GetCell(c)
        steps = 1 if cell.GetNumberOfPoints() == 4 else 6
        for e in range(4):
            edge = cell.GetEdge(e)
            weights = [0.0] * edge.GetNumberOfPoints()
            lines.InsertNextCell(steps + 1)
            for i in range(steps + 1):
                place = [0.0] * 3
                edge.EvaluateLocation(reference(0), (i / steps, 0, 0), place, weights)
                lines.InsertCellPoint(points.InsertNextPoint(place))
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetLines(lines)
    return result


def with_mirror_image(data):
    """The half section r >= 0 and its image at x < 0."""
    transform = vtkTransform()
    transform.Scale(-1, 1, 1)
    image = vtkTransformPolyDataFilter()
    image.SetInputData(data)
    image.SetTransform(transform)
    both = vtkAppendPolyData()
    both.AddInputData(data)
    both.AddInputConnection(image.GetOutputPort())
    both.Update()
    return both.GetOutput()


def region_facets(surface, region):
    """Triangles of one region of the surface; None: there are none."""
    part = vtkThreshold()
    part.SetInputData(surface)
    part.SetInputArrayToProcess(0, 0, 0, 0, "region")
    part.SetLowerThreshold(region - 0.5)
    part.SetUpperThreshold(region + 0.5)
    part.SetThresholdFunction(vtkThreshold.THRESHOLD_BETWEEN)
    part.Update()
    return facets(part.GetOutput(), 2) if part.GetOutput().GetNumberOfCells() > 0 else None


def cut(data):
    """Polylines in which the facets meet the plane y = 0 (slightly off it, where meshes have their lines)."""
    plane = vtkPlane()
    plane.SetOrigin(0, 1e-5 * data.GetLength(), 0)
    plane.SetNormal(0, 1, 0)
    cutter = vtkCutter()
    cutter.SetInputData(data)
    cutter.SetCutFunction(plane)
    joined = vtkCleanPolyData()
    joined.SetInputConnection(cutter.GetOutputPort())
    joined.ToleranceIsAbsoluteOn()
    joined.SetAbsoluteTolerance(2e-6 * data.GetLength())  # coordinates have single precision
    lines = vtkStripper()
    lines.SetInputConnection(joined.GetOutputPort())
    lines.JoinContiguousSegmentsOn()
    lines.SetMaximumLength(1000000)
    lines.Update()
    return lines.GetOutput()


def flat_actor(data, colour, width=1.0, opacity=1.0, offset=0.0):
    """Lines or faces in one colour, without shading, moved towards the viewer by the offset."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(data)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(*colour)
    look.SetLineWidth(width)
    look.SetOpacity(opacity)
    look.LightingOff()
    actor.AddPosition(0, -offset, 0)
    return actor


def line_through(points):
    places, lines = vtkPoints(), vtkCellArray()
    lines.InsertNextCell(len(points))
    for point in points:
        lines.InsertCellPoint(places.InsertNextPoint(point))
    data = vtkPolyData()
    data.SetPoints(places)
    data.SetLines(lines)
    return data


class Section:
    """All that the views in section show."""

    def __init__(self, surface, body, is_bounded):
        quadrilaterals = section_cells(body)
        self.is_half = quadrilaterals is body
        self.body, self.lines = facets(quadrilaterals, 2), mesh_lines(quadrilaterals)
        # Displacements are bounded; of other fields the colours leave out what grows without bound at the line.
        shown = self.body.GetPointData().GetArray("shown")
        self.range = shown.GetRange() if is_bounded and shown.GetRange()[0] < shown.GetRange()[1] else colour_range(self.body, "shown")
        if self.is_half:
            self.body, self.lines = with_mirror_image(self.body), with_mirror_image(self.lines)
        self.regions = [region_facets(surface, r) for r in (CAP, WETTED, DRY)]
        if None in self.regions:
            raise CannotDraw("the surface has no field 'region' with a drop, its base and the dry top of the body.")
        self.cap, self.base, self.dry = (cut(region) for region in self.regions)
        material = body.GetPointData().GetArray("material_position")
        self.undeformed_top = max(material.GetTuple(i)[2] for i in range(material.GetNumberOfTuples()))
        self.size = box_of(self.body)[1][0]

    def contact_point(self):
        """Where the profile of the drop meets the substrate, at x > 0."""
        base = [self.base.GetPoint(i) for i in range(self.base.GetNumberOfPoints())]
        return max(base)

    def liquid(self):
        """The section of the liquid, if its outline is found to be closed."""
        outline = vtkAppendPolyData()
        outline.AddInputData(self.cap)
        outline.AddInputData(self.base)
        joined = vtkCleanPolyData()
        joined.SetInputConnection(outline.GetOutputPort())
        joined.ToleranceIsAbsoluteOn()
        joined.SetAbsoluteTolerance(1e-4 * self.size)
        lines = vtkStripper()
        lines.SetInputConnection(joined.GetOutputPort())
        lines.JoinContiguousSegmentsOn()
        lines.SetMaximumLength(1000000)
        lines.Update()
        if lines.GetOutput().GetNumberOfLines() == 0 or not all_closed(lines.GetOutput()):
            return None
        inside = vtkContourTriangulator()
        inside.SetInputData(lines.GetOutput())
        inside.Update()
        return inside.GetOutput()

    def view(self, place, colours, centre, half_height, line_width):
        """The window of the given height about the centre (x, z)."""
        renderer = vtkRenderer()
        renderer.SetViewport(*place)
        renderer.SetBackground(1, 1, 1)
        producer = vtkTrivialProducer()
        producer.SetOutput(self.body)
        filling = coloured_actor(producer, colours)
        filling.GetProperty().LightingOff()
        layer = 1e-3 * self.size
        liquid = self.liquid()
        if liquid is not None:
            renderer.AddActor(flat_actor(liquid, LIQUID))
        renderer.AddActor(filling)
        renderer.AddActor(flat_actor(self.lines, MESH_LINE, 1.0, 0.30, layer))
        dashes, step = [], 0.012 * 2 * half_height * view_aspect(place)
        for i in range(-60, 60):
            x = centre[0] + i * step
            if abs(x) < self.size / 2:
                dashes.append(flat_actor(line_through([(x, 0, self.undeformed_top), (x + 0.5 * step, 0, self.undeformed_top)]), INK, 1.2, 0.7, 2 * layer))
        for dash in dashes:
            renderer.AddActor(dash)
        for line in (self.dry, self.base):
            renderer.AddActor(flat_actor(line, INK, 0.7 * line_width, 1.0, 3 * layer))
        renderer.AddActor(flat_actor(self.cap, DROP_LINE, line_width, 1.0, 4 * layer))

        camera = renderer.GetActiveCamera()
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(centre[0], 0, centre[1])
        camera.SetPosition(centre[0], -10 * self.size, centre[1])
        camera.SetViewUp(0, 0, 1)
        camera.SetParallelScale(half_height)
        renderer.ResetCameraClippingRange()
        return renderer


def rectangle(centre, half_width, half_height):
    (x, z), w, h = centre, half_width, half_height
    return line_through([(x - w, 0, z - h), (x + w, 0, z - h), (x + w, 0, z + h), (x - w, 0, z + h), (x - w, 0, z - h)])


def with_heights(data, zero):
    """The same with z over the undeformed top as the active scalar: the vertical displacement of a flat top."""
    heights = vtkDoubleArray()
    heights.SetName("shown")
    for i in range(data.GetNumberOfPoints()):
        heights.InsertNextValue(data.GetPoint(i)[2] - zero)
    data.GetPointData().SetScalars(heights)
    return data


def smooth(data):
    """With normals, and without creases between cells."""
    joined = vtkCleanPolyData()
    joined.SetInputData(data)
    joined.ToleranceIsAbsoluteOn()
    joined.SetAbsoluteTolerance(2e-6 * data.GetLength())
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(joined.GetOutputPort())
    normals.SetFeatureAngle(35)
    normals.ConsistencyOff()
    return normals


def space_view(section, body, colours, shows_heights):
    """The drop on the body from above; what is not solved for by symmetry stays away."""
    renderer = vtkRenderer()
    renderer.SetViewport(*SPACE_VIEW)
    renderer.SetBackground(1, 1, 1)
    parts, shown = [], section.regions
    if body.GetCellType(0) == VTK_LAGRANGE_HEXAHEDRON:
        outside = facets(body, 2)
        parts.append(coloured_actor(smooth(outside), colours))
        shown = shown + [outside]
    else:
        for skin in section.regions[WETTED:]:
            parts.append(coloured_actor(smooth(with_heights(skin, section.undeformed_top)), colours) if shows_heights
                         else grey_actor(smooth(skin), 1))
    drop = grey_actor(smooth(section.regions[CAP]), 0.5)
    drop.GetProperty().SetColor(0.40, 0.64, 0.90)
    drop.GetProperty().SetSpecular(0.4)
    drop.GetProperty().SetSpecularPower(30)
    for actor in parts + [drop]:
        actor.GetProperty().SetInterpolationToPhong()
        actor.GetProperty().SetAmbient(0.36)
        actor.GetProperty().SetDiffuse(0.75)
        renderer.AddActor(actor)

    camera = renderer.GetActiveCamera()
    elevation, azimuth = math.radians(24), math.radians(-62)
    direction = (math.cos(elevation) * math.cos(azimuth), math.cos(elevation) * math.sin(azimuth), math.sin(elevation))
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*direction)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(22)
    renderer.ResetCamera()
    fill_view(renderer, shown, SPACE_VIEW)
    renderer.AutomaticLightCreationOff()
    for position, strength in (((-0.9, 1.3, 1.4), 0.80), ((1.6, 0.2, 1.0), 0.30), ((-0.4, -1.4, 0.6), 0.15)):
        light = vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(*position)
        light.SetFocalPoint(0, 0, 0)
        light.SetIntensity(strength)
        renderer.AddLight(light)
    return renderer


def draw(surface, body, field, title):
    component_of(body, field)
    section = Section(surface, body, field.startswith("displacement"))
    low, high = section.range
    colours = colour_map(low, high)
    window = white_window()

    boxes = [data.GetBounds() for data in (section.body, section.cap)]
    bottom, top = min(b[4] for b in boxes), max(b[5] for b in boxes)
    left, right = min(b[0] for b in boxes), max(b[1] for b in boxes)
    half_height = max((top - bottom) / 2, (right - left) / 2 / view_aspect(MAIN_VIEW)) / 0.95
    whole = section.view(MAIN_VIEW, colours, ((left + right) / 2, (bottom + top) / 2), half_height, 4)

    # The line in the middle of a window in which the ridge fills a quarter of the height.
    x, _, z = section.contact_point()
    zoom = min(max(2 * abs(z - section.undeformed_top), 0.01 * (right - left)), 0.08 * (right - left))
    near = section.view(ZOOM_VIEW, colours, (x, z), zoom, 5)
    frame = flat_actor(rectangle((x, z), zoom * view_aspect(ZOOM_VIEW), zoom), INK, 1.5, 0.8, 8e-3 * section.size)
    whole.AddActor(frame)
    border = flat_actor(rectangle((x, z), 0.998 * zoom * view_aspect(ZOOM_VIEW), 0.996 * zoom), INK, 1.5, 0.8, 8e-3 * section.size)
    near.AddActor(border)
    for view in (whole, near, space_view(section, body, colours, field == "displacement:2")):
        window.AddRenderer(view)

    page = vtkRenderer()
    page.SetLayer(1)
    page.AddViewProp(text(title, 0.5, 0.965, 34, bold=True))
    page.AddViewProp(text(TITLES.get(field, field.replace("_", " ")), 0.5, 0.125, 24))
    page.AddViewProp(colour_bar(colours, low, high))
    window.AddRenderer(page)
    return window


def main():
    parser = argparse.ArgumentParser(description="Draws a drop on a deformable body in section into a PNG file.")
    parser.add_argument("vtu", help="the surface, with the field 'region'")
    parser.add_argument("body")
    parser.add_argument("png")
    parser.add_argument("--field", default="displacement:2", help="point field of the body that gives the colours")
    parser.add_argument("--title", default="")
    arguments = parser.parse_args()
    try:
        write_picture(draw(read_grid(arguments.vtu), read_grid(arguments.body), arguments.field, arguments.title), arguments.png)
    except CannotDraw as error:
        print(error, file=sys.stderr)
        sys.exit(1)


if __name__ == "__main__":
    main()
