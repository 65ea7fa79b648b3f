"""A state file with which ParaView opens the fields of a run as they are drawn here: OUT/fields_paraview.py."""

STATE = '''# For ParaView: File, Load State; or: paraview --state=fields_paraview.py
from paraview.simple import *

paraview.simple._DisableFirstRenderCameraReset()
fields = PVDReader(registrationName="fields", FileName={pvd!r})
alive = Threshold(registrationName="alive", Input=fields)  # eroded elements are in the files, with alive = 0
alive.Scalars = ["CELLS", "alive"]
alive.LowerThreshold, alive.UpperThreshold = 0.5, 1.0
view = GetActiveViewOrCreate("RenderView")
view.CameraParallelProjection = 1
view.CameraFocalPoint, view.CameraPosition, view.CameraViewUp = {centre}, {position}, {up}
view.CameraParallelScale = {scale!r}
shown = Show(alive, view)
shown.Representation = "Surface With Edges"
ColorBy(shown, {array!r})
colours = GetColorTransferFunction({name!r})
colours.RescaleTransferFunction({low!r}, {high!r})
shown.SetScalarBarVisibility(view, True)
bar = GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle = {label!r}, ""
bar.TitleFontSize = bar.LabelFontSize = 12
times = GetTimeKeeper().TimestepValues
GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
GetAnimationScene().AnimationTime = times[-1] if len(times) > 1 else times
Render(view)
'''


def state_text(pvd, quantity, colours, frame):
    """The state for the fields in `pvd` (an absolute path), in the colours and from the place of the pictures."""
    array = ["POINTS" if quantity.on_points else "CELLS", quantity.name]
    if quantity.signed:
        array.append(str(quantity.title).rpartition("_")[2].upper())
    position = frame.centre + (frame.depth + frame.width + frame.height) * frame.camera.toward
    return STATE.format(pvd=pvd, centre=numbers(frame.centre), position=numbers(position), up=numbers(frame.camera.up),
                        scale=float(0.5 * frame.height), array=tuple(array), name=quantity.name, low=float(colours.range[0]),
                        high=float(colours.range[1]), label=colours.label or quantity.name)


def numbers(vector):
    return [float(x) for x in vector]
