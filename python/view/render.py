"""Surfaces drawn by VTK with light from the viewer's left shoulder and shadows in corners."""

import numpy as np
import vtkmodules.vtkRenderingOpenGL2 as opengl
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingCore import (vtkActor, vtkLight, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)
from PIL import Image, ImageChops

# Drawn so many times larger, and made smaller afterwards: smooth outlines, and edges of less than a pixel.
SUPERSAMPLING = 2


class Window:
    """A window that looks at a Frame; draw() gives what is seen of some surfaces.

    Colours and shadows are drawn apart: shadows in corners (ambient occlusion) take sixteen looks into the depths around each
    pixel, without a graphics card most of the time of a picture, and are soft enough for larger pixels.
    """

    def __init__(self, frame):
        self.colours, self.shadows = Layer(frame), Layer(frame)
        self.colours.light()
        self.shadows.shade_corners()

    def resize(self, width, height, shadow_pixel):
        """[pixel]; shadow_pixel: so many pixels have one of their shadows."""
        self.size = width, height
        self.colours.resize(SUPERSAMPLING * width, SUPERSAMPLING * height)
        self.shadows.resize(max(width // shadow_pixel, 1), max(height // shadow_pixel, 1))

    def draw(self, surfaces, colours, edges):
        """A PIL image (RGBA), transparent where nothing is. surfaces: vtkPolyData; edges: width of mesh lines [pixel], 0 for
        none."""
        self.colours.show([coloured(surface, colours, edges) for surface in surfaces])
        self.shadows.show([white(surface) for surface in surfaces])
        seen = self.colours.read().reduce(SUPERSAMPLING)
        shadows = self.shadows.read().convert("RGB").resize(self.size, Image.BILINEAR)
        shaded = ImageChops.multiply(seen.convert("RGB"), shadows)
        shaded.putalpha(seen.getchannel("A"))
        return shaded

    def close(self):
        """Before the display goes."""
        self.colours.window.Finalize()
        self.shadows.window.Finalize()


class Layer:
    """A window of VTK, off screen and transparent."""

    def __init__(self, frame):
        self.frame = frame
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetAlphaBitPlanes(1)
        self.renderer = vtkRenderer()
        self.renderer.SetBackground(1.0, 1.0, 1.0)
        self.renderer.SetBackgroundAlpha(0.0)
        self.window.AddRenderer(self.renderer)
        self.look()

    def resize(self, width, height):
        self.window.SetSize(width, height)

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
        occlusion.SetBias(0.005 * size)  # less than about a pixel would be shadows of flat faces on themselves
        occlusion.SetKernelSize(16)
        occlusion.BlurOn()
        occlusion.SetDelegatePass(steps)
        self.renderer.SetPass(occlusion)

    def show(self, actors):
        self.renderer.RemoveAllViewProps()
        for actor in actors:
            self.renderer.AddActor(actor)
        self.window.Render()

    def read(self):
        """A PIL image (RGBA) of what is shown."""
        image = vtkWindowToImageFilter()
        image.SetInput(self.window)
        image.SetInputBufferTypeToRGBA()
        image.ReadFrontBufferOff()
        image.ShouldRerenderOff()
        image.Update()
        pixels = vtk_to_numpy(image.GetOutput().GetPointData().GetScalars())
        return Image.frombytes("RGBA", self.window.GetSize(), pixels.tobytes(), "raw", "RGBA", 0, -1)


def lookup_table(colours):
    table = vtkLookupTable()
    table.SetTable(numpy_to_vtk((255.0 * colours.table).round().astype(np.uint8), deep=True))
    table.SetRange(*colours.range)
    table.SetNanColor(0.6, 0.6, 0.6, 1.0)
    return table


def coloured(surface, colours, edges):
    """An actor with the colours of the values, and mesh lines of a width [pixel]."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(lookup_table(colours))
    mapper.UseLookupTableScalarRangeOn()
    # Values of nodes are interpolated, not their colours; of elements there is nothing to interpolate.
    mapper.SetInterpolateScalarsBeforeMapping(surface.GetPointData().GetScalars() is not None)
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


def white(surface):
    """An actor that shows shadows alone."""
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    look = actor.GetProperty()
    look.SetColor(1.0, 1.0, 1.0)
    look.SetAmbient(1.0)
    look.SetDiffuse(0.0)
    look.SetSpecular(0.0)
    return actor
