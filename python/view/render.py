"""Surfaces drawn by VTK with light from the viewer's left shoulder and shadows in corners."""

import numpy as np
import vtkmodules.vtkRenderingOpenGL2 as opengl
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)

# Drawn so many times larger, and made smaller afterwards: smooth outlines, and edges of less than a pixel.
SUPERSAMPLING = 2


class Window:
    """A window of some pixels that looks at a Frame; draw() gives what is seen of some surfaces."""

    def __init__(self, frame, width, height):
        self.size = width, height
        self.frame = frame
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SUPERSAMPLING * width, SUPERSAMPLING * height)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.window.AddRenderer(self.renderer)
        self.look()
        self.light()
        self.shade_corners()

    def look(self):
        frame, camera = self.frame, self.renderer.GetActiveCamera()
        reach = frame.depth + frame.width + frame.height
        camera.ParallelProjectionOn()
        camera.SetFocalPoint(frame.centre)
        camera.SetPosition(frame.centre + reach * frame.camera.toward)
        camera.SetViewUp(frame.camera.up)
        camera.SetParallelScale(0.5 * frame.height)
        camera.SetClippingRange(reach - 0.6 * frame.depth - 1e-3 * reach, reach + 0.6 * frame.depth + 1e-3 * reach)

    def light(self):
        """A main light, and a weak one from the other side; both go with the camera."""
        self.renderer.AutomaticLightCreationOff()
        for position, intensity in (((-0.35, 0.6, 1.0), 0.85), ((0.7, -0.2, 0.8), 0.25)):
            light = vtkLight()
            light.SetLightTypeToCameraLight()
            light.SetPosition(position)
            light.SetIntensity(intensity)
            self.renderer.AddLight(light)

    def shade_corners(self):
        steps = opengl.vtkRenderStepsPass()
        occlusion = opengl.vtkSSAOPass()
        size = max(self.frame.width, self.frame.height)
        occlusion.SetRadius(0.06 * size)
        occlusion.SetBias(0.0015 * size)
        occlusion.SetKernelSize(16)
        occlusion.BlurOn()
        occlusion.SetDelegatePass(steps)
        self.renderer.SetPass(occlusion)

    def draw(self, surfaces, colours, edges):
        """(height, width, 3) bytes. surfaces: vtkPolyData; edges: width of mesh lines [pixel], 0 for none."""
        self.renderer.RemoveAllViewProps()
        for surface in surfaces:
            self.renderer.AddActor(actor_of(surface, colours, edges))
        self.window.Render()
        return self.read()

    def read(self):
        image = vtkWindowToImageFilter()
        image.SetInput(self.window)
        image.ReadFrontBufferOff()
        image.ShouldRerenderOff()
        image.Update()
        width, height = self.window.GetSize()
        pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars()).reshape(height, width, 3)[::-1]
        n = SUPERSAMPLING
        return (pixels.astype(np.uint16).reshape(height // n, n, width // n, n, 3).sum(axis=(1, 3)) // (n * n)).astype(np.uint8)

    def close(self):
        """Before the display goes."""
        self.window.Finalize()


def lookup_table(colours):
    table = vtkLookupTable()
    table.SetTable(numpy_to_vtk((255.0 * colours.table).round().astype(np.uint8), deep=True))
    table.SetRange(*colours.range)
    table.SetNanColor(0.6, 0.6, 0.6, 1.0)
    return table


def actor_of(surface, colours, edges):
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(lookup_table(colours))
    mapper.UseLookupTableScalarRangeOn()
    mapper.InterpolateScalarsBeforeMappingOn()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetAmbient(0.36)
    look.SetDiffuse(0.62)
    look.SetSpecular(0.0)
    if edges > 0.0:
        look.EdgeVisibilityOn()
        look.SetEdgeColor(0.22, 0.22, 0.25)
        look.SetLineWidth(SUPERSAMPLING * edges)
    return actor
