# SPDX-License-Identifier: LGPL-2.1-or-later
"""Colours of pictures: the range of a field, its colour map, the bar that explains it."""
import math

from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersCore import vtkPointDataToCellData
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction

INK = (0.13, 0.14, 0.17)
CONSTANT = 0.1  # part of the largest value by which a field that counts as constant may vary


class CannotDraw(Exception):
    """The message is for the user."""


def percentiles(surface, field):
    """The 1st and 99th percentile by area."""
    sizes = vtkCellSizeFilter()
    sizes.SetInputData(surface)
    sizes.ComputeLengthOff()
    sizes.ComputeVolumeOff()
    sizes.ComputeVertexCountOff()
    cells = vtkPointDataToCellData()
    cells.SetInputConnection(sizes.GetOutputPort())
    cells.Update()
    values, areas = cells.GetOutput().GetCellData().GetArray(field), cells.GetOutput().GetCellData().GetArray("Area")
    pairs = sorted((values.GetValue(i), areas.GetValue(i)) for i in range(values.GetNumberOfTuples())
                   if math.isfinite(values.GetValue(i)))
    if not pairs:
        raise CannotDraw(f"the field '{field}' has no finite value.")
    total, below, low, high = sum(area for _, area in pairs), 0.0, pairs[0][0], pairs[-1][0]
    for value, area in pairs:
        if below <= 0.01 * total:
            low = value
        if below <= 0.99 * total:
            high = value
        below += area
    return low, high


def colour_range(surface, field):
    """Percentiles: single nodes that stick out do not bleach the rest."""
    low, high = percentiles(surface, field)
    if field == "tilt_length":  # what is largest around an inclusion or a defect is not much of the surface
        return 0, max(surface.GetPointData().GetArray(field).GetRange()[1], 0.01)
    # A constant field stays one colour instead of showing its round-off.
    least = CONSTANT * max(abs(low), abs(high)) or 1.0
    if high - low < least:
        low, high = (low + high - least) / 2, (low + high + least) / 2
    return low, high


def colour_map(low, high, field=""):
    """Diverging about zero (blue inward, red outward) where the field has both signs, else from dark to bright; of tilt
    bright all over, as a ground for needles."""
    colours = vtkColorTransferFunction()
    colours.SetNanColor(0.6, 0.6, 0.6)
    colours.SetColorSpaceToLab()
    if low < 0 < high:
        extreme = max(-low, high)
        blues = [(0.10, 0.24, 0.56), (0.17, 0.44, 0.73), (0.36, 0.64, 0.83), (0.66, 0.82, 0.90)]
        reds = [(0.62, 0.03, 0.16), (0.80, 0.20, 0.20), (0.90, 0.44, 0.34), (0.96, 0.70, 0.58)]
        for i in range(4):
            colours.AddRGBPoint(-extreme * (1 - i / 4), *blues[i])
            colours.AddRGBPoint(extreme * (1 - i / 4), *reds[i])
        colours.AddRGBPoint(0.0, 0.93, 0.92, 0.91)
    elif field == "tilt_length":
        steps = [(0.89, 0.91, 0.93), (0.71, 0.84, 0.80), (0.93, 0.83, 0.52), (0.94, 0.62, 0.27), (0.88, 0.41, 0.20)]
        for i, step in enumerate(steps):
            colours.AddRGBPoint(low + (high - low) * i / (len(steps) - 1), *step)
    else:
        # Viridis without its darkest part, which shading would turn to black.
        steps = [(0.254, 0.265, 0.530), (0.207, 0.372, 0.553), (0.164, 0.471, 0.558), (0.128, 0.567, 0.551),
                 (0.135, 0.659, 0.518), (0.267, 0.749, 0.441), (0.478, 0.821, 0.318), (0.741, 0.873, 0.150),
                 (0.993, 0.906, 0.144)]
        for i, step in enumerate(steps):
            colours.AddRGBPoint(low + (high - low) * i / (len(steps) - 1), *step)
    return colours


def tick_values(low, high):
    """Round numbers inside [low, high], about five."""
    raw = (high - low) / 5
    power = 10.0 ** math.floor(math.log10(raw))
    step = next(m * power for m in (1, 2, 2.5, 5, 10) if m * power >= raw * 0.999)
    first = math.ceil(low / step - 1e-9)
    return [i * step for i in range(first, int(math.floor(high / step + 1e-9)) + 1)]


def colour_bar(colours, low, high):
    bar = vtkScalarBarActor()
    shown = vtkColorTransferFunction()  # the bar shows the range that occurs, not the symmetric one
    shown.DeepCopy(colours)
    shown.AdjustRange((low, high))
    bar.SetLookupTable(shown)
    bar.SetOrientationToHorizontal()
    bar.SetMaximumNumberOfColors(512)
    bar.GetPositionCoordinate().SetCoordinateSystemToNormalizedViewport()
    bar.SetPosition(0.24, 0.052)
    bar.SetWidth(0.52)
    bar.SetHeight(0.052)
    bar.SetBarRatio(0.45)
    bar.SetTitle("")
    bar.SetNumberOfLabels(0)
    ticks = tick_values(low, high)
    custom = vtkDoubleArray()
    for value in ticks:
        custom.InsertNextValue(value)
    bar.SetCustomLabels(custom)
    bar.UseCustomLabelsOn()
    bar.SetLabelFormat("%.4g")
    bar.UnconstrainedFontSizeOn()
    style = bar.GetLabelTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(22)
    style.SetColor(*INK)
    style.ItalicOff()
    style.BoldOff()
    style.ShadowOff()
    return bar
