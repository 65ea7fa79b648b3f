"""What of a mesh is seen: the faces of the elements shown, cut by a plane where one is given."""

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import VTK_HEXAHEDRON, vtkCellArray, vtkPlane, vtkUnstructuredGrid
from vtkmodules.vtkCommonTransforms import vtkTransform
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkClipPolyData, vtkCutter, vtkPolyDataNormals, vtkReverseSense
from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkFiltersGeneral import vtkTransformPolyDataFilter

VALUES = "values"


def grid_of(mesh, quantity, elements):
    """A vtkUnstructuredGrid of some elements, with the values to be drawn."""
    grid = vtkUnstructuredGrid()
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.nan_to_num(mesh.points), deep=True))
    grid.SetPoints(points)
    hexahedra = mesh.hexahedra[elements].astype(np.int64)
    cells = vtkCellArray()
    cells.SetData(8, numpy_to_vtkIdTypeArray(hexahedra.ravel(), deep=True))
    grid.SetCells(VTK_HEXAHEDRON, cells)
    values = quantity.of(mesh)
    array = numpy_to_vtk(values if quantity.on_points else values[elements], deep=True)
    array.SetName(VALUES)
    (grid.GetPointData() if quantity.on_points else grid.GetCellData()).SetScalars(array)
    return grid


def run_filter(filter_, data):
    filter_.SetInputData(data)
    filter_.Update()
    return filter_.GetOutput()


def surface_of(grid):
    """Faces that belong to one element only, as polygons with outward normals."""
    return run_filter(vtkGeometryFilter(), grid)


def cut_surface(grid, surface, cut):
    """The surface on the kept side of a plane, and the section of the elements with it."""
    plane = vtkPlane()
    plane.SetNormal(cut.normal)
    # A plane through faces of elements would touch elements on both sides: it goes a hair into the kept ones.
    low, high = np.array(surface.GetBounds()).reshape(3, 2).T
    plane.SetOrigin(cut.origin + 1e-6 * np.linalg.norm(high - low) * np.array(cut.normal))
    clip = vtkClipPolyData()
    clip.SetClipFunction(plane)
    section = vtkCutter()
    section.SetCutFunction(plane)
    section.GenerateTrianglesOff()
    both = vtkAppendPolyData()
    both.AddInputData(run_filter(clip, surface))
    both.AddInputData(run_filter(section, grid))
    both.Update()
    return both.GetOutput()


def with_normals(surface):
    """Normals of nodes, of which edges sharper than 30 degrees have two: curved bodies look curved."""
    normals = vtkPolyDataNormals()
    normals.SetFeatureAngle(30.0)
    normals.ConsistencyOff()
    return run_filter(normals, surface)


def visible_surface(mesh, quantity, elements, cut=None):
    """vtkPolyData of what is seen of some elements (indices), with VALUES and normals."""
    grid = grid_of(mesh, quantity, elements)
    surface = surface_of(grid)
    if cut is not None and surface.GetNumberOfPoints() > 0:
        surface = cut_surface(grid, surface, cut)
    return with_normals(surface)


def mirrored(surface, scale, opposite):
    """The image of a surface at planes through the origin, seen from outside as it is; its values with the other sign where
    they are opposite."""
    mirror = vtkTransform()
    mirror.Scale(scale)
    place = vtkTransformPolyDataFilter()
    place.SetTransform(mirror)
    image = run_filter(place, surface)
    if np.prod(scale) < 0.0:
        turn = vtkReverseSense()  # of the cells; normals have been turned with them
        turn.ReverseNormalsOff()
        image = run_filter(turn, image)
    if opposite:
        negate(image)
    return image


def negate(surface):
    for data in (surface.GetPointData(), surface.GetCellData()):
        array = data.GetArray(VALUES)
        if array is not None:
            opposite = numpy_to_vtk(-vtk_to_numpy(array), deep=True)
            opposite.SetName(VALUES)
            data.SetScalars(opposite)
