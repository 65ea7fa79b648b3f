"""A state file with which ParaView opens the fields of a run as they are drawn here: OUT/fields_paraview.py."""

import numpy as np

STATE = '''# For ParaView: File, Load State; or: paraview --state=fields_paraview.py
import os
from paraview.simple import *

# The fields lie beside this file. Where ParaView does not say where that is, it is the folder that it was started in.
folder = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
pvd = os.path.join(folder, "fields.pvd")
if not os.path.exists(pvd):
    raise RuntimeError(pvd + " is not there: start ParaView in the folder of the run, or set `folder` in this file")

paraview.simple._DisableFirstRenderCameraReset()
fields = PVDReader(registrationName="fields", FileName=pvd)
alive = Threshold(registrationName="alive", Input=fields)  # eroded elements are in the files, with alive = 0
alive.Scalars = ["CELLS", "alive"]
alive.LowerThreshold, alive.UpperThreshold = 0.5, 1.0
seen = alive
{parts}
view = GetActiveViewOrCreate("RenderView")
view.UseColorPaletteForBackground = 0
view.Background = [1.0, 1.0, 1.0]
view.OrientationAxesLabelColor = [0.16, 0.16, 0.18]
view.CameraParallelProjection = 1
view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = {centre}, {position}, {up}
view.CenterOfRotation = {centre}
width, height = view.ViewSize
view.CameraParallelScale = max({half_height!r}, {half_width!r} * height / max(0.85 * width, 1))  # the bar is beside the bodies
shown = Show(seen, view)
shown.Representation = {representation!r}
shown.EdgeColor = [0.22, 0.22, 0.25]
ColorBy(shown, {array!r})
colours = GetColorTransferFunction({name!r})
colours.AutomaticRescaleRangeMode = "Never"
{colours}
colours.NanColor = [0.6, 0.6, 0.6]
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle = {label!r}, ""
bar.TitleColor = bar.LabelColor = [0.16, 0.16, 0.18]
bar.TitleFontSize = bar.LabelFontSize = 14
bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.87, 0.2], 0.6
times = GetTimeKeeper().TimestepValues
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
GetAnimationScene().AnimationTime = times[-1] if hasattr(times, "__len__") else times
Render(view)
'''

BODIES = '''chosen = []
for body in {bodies}:
    one = Threshold(registrationName=f"body {{body}}", Input=seen)
    one.Scalars = ["CELLS", "body"]
    one.LowerThreshold, one.UpperThreshold = body - 0.5, body + 0.5
    chosen.append(one)
seen = AppendDatasets(registrationName="bodies", Input=chosen)'''

CUT = '''seen = Clip(registrationName="cut", Input=seen)
seen.ClipType = "Plane"
seen.ClipType.Origin, seen.ClipType.Normal = {origin}, {normal}
seen.Invert = 0'''

MIRROR = '''seen = Reflect(registrationName="mirror {axis}", Input=seen)
seen.Plane, seen.Center, seen.CopyInput = "{axis}", 0.0, 1'''

SCALE = '''colours.ColorSpace = "RGB"
colours.RGBPoints = {points}  # value, red, green, blue'''

NAMES = '''colours.InterpretValuesAsCategories = 1
colours.Annotations = {annotations}
colours.IndexedColors = {indexed}'''


def state_text(drawing):
    """The state for the fields of a Drawing: its bodies, cut and mirror images, its colours, seen from where it sees them."""
    quantity, colours, frame = drawing.quantity, drawing.colours, drawing.frame
    array = ["POINTS" if quantity.on_points else "CELLS", quantity.name]
    position = frame.centre + (frame.depth + frame.width + frame.height) * frame.camera.toward
    if quantity.components:
        # Components without a name in the file have the names X, Y, Z there.
        array.append("Magnitude" if quantity.component is None else quantity.components[quantity.component])
    return STATE.format(
        parts="\n".join(parts(drawing)), centre=numbers(frame.centre), position=numbers(position), up=numbers(frame.camera.up),
        half_height=float(0.5 * frame.height), half_width=float(0.5 * frame.width), array=tuple(array), name=quantity.name,
        colours=colour_lines(quantity, colours), label=colours.label or quantity.name,
        representation="Surface With Edges" if drawing.options.edges else "Surface")


def parts(drawing):
    """What of the fields is seen."""
    if len(drawing.bodies) < len(drawing.names):
        yield BODIES.format(bodies=[int(body) for body in drawing.bodies])
    if drawing.cut is not None:
        yield CUT.format(origin=numbers(drawing.cut.origin), normal=numbers(drawing.cut.normal))
    for axis in drawing.options.mirror:
        yield MIRROR.format(axis=axis.upper())


def colour_lines(quantity, colours):
    if colours.names:
        annotations = [text for i, name in enumerate(colours.names) for text in (str(i), name)]
        return NAMES.format(annotations=annotations, indexed=numbers(colours.table[:, :3].ravel()))
    places = np.linspace(0, len(colours.table) - 1, 33).round().astype(int)
    low, high = colours.range
    values = low + (high - low) * places / (len(colours.table) - 1)
    component = "Magnitude" if quantity.component is None else "Component"
    lines = SCALE.format(points=numbers(np.column_stack([values, colours.table[places, :3]]).ravel()))
    if quantity.components:
        lines += f'\ncolours.VectorMode, colours.VectorComponent = "{component}", {quantity.component or 0}'
    return lines


def numbers(vector):
    return [float(f"{x:.9g}") for x in vector]
