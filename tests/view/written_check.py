"""The viewer reads what the program writes: written_check.py OUT_DIR, the latter written by tests/program/view_test.cpp.

OUT_DIR holds two outputs of two blocks of cubes of side 0.25: 4 x 2 x 1, and 1 x 1 x 3 without its last element.
"""

import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python"))

from view.fields import BadInput, read_pvd, read_vtu
from view.history import read_history
from view.quantity import shown

import numpy as np

folder = sys.argv[1]
outputs = read_pvd(os.path.join(folder, "fields.pvd"))
assert [time for time, _ in outputs] == [0.0, 2.5e-5], outputs

mesh = read_vtu(outputs[1][1])
assert mesh.points.shape == (46, 3) and mesh.hexahedra.shape == (11, 8)
assert mesh.units["stress"] == "psi", mesh.units
assert mesh.names == ["rod", "plate"], mesh.names
assert mesh.components["stress"] == ["xx", "yy", "zz", "xy", "yz", "zx"]
assert (mesh.cell_data["plastic_strain"] == 0.125 * np.arange(11)).all()
assert (mesh.point_data["velocity"][:, 1] == -2.0 * np.arange(46)).all()
assert shown(mesh).tolist() == [True] * 10 + [False]

columns, units = read_history(os.path.join(folder, "history.csv"))
assert columns["time"][-1] == 2.5e-5 and units["energy"] == "lbf in"
assert columns["rod_mass_remaining"][0] == 1.0

cut = os.path.join(folder, "cut.vtu")
with open(outputs[0][1], "rb") as whole, open(cut, "wb") as part:
    part.write(whole.read()[:-200])
try:
    read_vtu(cut)
    raise AssertionError("a file cut short was taken")
except BadInput as error:
    assert "cut.vtu" in str(error)

try:
    import vtkmodules.all as vtk
except ModuleNotFoundError:
    sys.exit(0)  # VTK, and so ParaView, reads the same file
reader = vtk.vtkXMLUnstructuredGridReader()
reader.SetFileName(outputs[1][1])
reader.Update()
grid = reader.GetOutput()
names = grid.GetFieldData().GetAbstractArray("body_names")
assert [names.GetValue(i) for i in range(names.GetNumberOfValues())] == ["rod", "plate"]
assert grid.GetNumberOfCells() == 11 and grid.GetCellData().GetArray("plastic_strain").GetValue(10) == 1.25
