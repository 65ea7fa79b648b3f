#!/usr/bin/env python3
"""Writes the files of this folder with VTK: a unit cube as a voxel, one as a hexahedron, a wedge on it; a quadrangle and
cells and points with integers. Only for making them anew."""

import vtk

POINTS = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1),
          (2, 0, 0), (2, 1, 0), (2, 0, 1), (2, 1, 1), (1.5, 0, 2), (1.5, 1, 2)]
CELLS = [(vtk.VTK_VOXEL, [0, 1, 2, 3, 4, 5, 6, 7]), (vtk.VTK_QUAD, [0, 4, 6, 2]),
         (vtk.VTK_HEXAHEDRON, [1, 8, 9, 3, 5, 10, 11, 7]), (vtk.VTK_WEDGE, [5, 10, 12, 7, 11, 13])]


def grid():
    points = vtk.vtkPoints()
    points.SetDataTypeToDouble()
    for point in POINTS:
        points.InsertNextPoint(point)
    grid = vtk.vtkUnstructuredGrid()
    grid.SetPoints(points)
    for kind, nodes in CELLS:
        grid.InsertNextCell(kind, len(nodes), nodes)
    for data, name, values in [(grid.GetCellData(), "material", [3, 8, 3, 4]), (grid.GetCellData(), "chosen", [1, 0, 0, 1]),
                               (grid.GetPointData(), "held", [1, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 0, 2, 2])]:
        array = vtk.vtkIntArray()
        array.SetName(name)
        for value in values:
            array.InsertNextValue(value)
        data.AddArray(array)
    strain = vtk.vtkDoubleArray()
    strain.SetName("strain of the cells")
    for value in range(4):
        strain.InsertNextValue(0.5 * value)
    grid.GetCellData().AddArray(strain)
    return grid


def main():
    for name, binary, version in [("ascii", False, 42), ("binary", True, 42), ("ascii_51", False, 51), ("binary_51", True, 51)]:
        writer = vtk.vtkUnstructuredGridWriter()
        writer.SetInputData(grid())
        writer.SetFileName(f"grid_{name}.vtk")
        writer.SetFileVersion(version)
        writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
        writer.Write()
    for name, mode, packed, raw, wide in [
            ("ascii", "Ascii", False, False, False), ("inline", "Binary", False, False, False),
            ("inline_64", "Binary", False, False, True), ("inline_zlib", "Binary", True, False, False),
            ("raw", "Appended", False, True, True), ("raw_zlib", "Appended", True, True, True),
            ("base64", "Appended", False, False, False), ("base64_zlib", "Appended", True, False, True)]:
        writer = vtk.vtkXMLUnstructuredGridWriter()
        writer.SetInputData(grid())
        writer.SetFileName(f"grid_{name}.vtu")
        getattr(writer, f"SetDataModeTo{mode}")()
        writer.SetCompressorTypeToZLib() if packed else writer.SetCompressorTypeToNone()
        writer.SetBlockSize(64)  # several blocks even here
        writer.SetEncodeAppendedData(not raw)
        writer.SetHeaderTypeToUInt64() if wide else writer.SetHeaderTypeToUInt32()
        writer.Write()


if __name__ == "__main__":
    main()
