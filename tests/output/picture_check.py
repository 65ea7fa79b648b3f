"""Checks what bench/picture draws from: picture_check.py BENCH_FOLDER OUT_DIR, the latter written by picture_test.cpp.

OUT_DIR holds two outputs of two blocks of cubes of side 0.25: 4 x 2 x 1, and 1 x 1 x 3 without its last element.
"""

import os
import sys

bench, folder = sys.argv[1:]
sys.path.insert(0, bench)

import numpy as np

from plot.history_plot import read_history, time_scale
from plot.surface import exposed_quads, mirror_quads, project
from plot.vtu import BadInput, read_pvd, read_vtu


def volume(corners):
    """Of what the quads enclose: a third of the flux of the position through them."""
    normals = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]) / 2.0
    return float((corners.mean(axis=1) * normals).sum() / 3.0)


outputs = read_pvd(os.path.join(folder, "fields.pvd"))
assert [time for time, _ in outputs] == [0.0, 2.5e-5], outputs

mesh = read_vtu(outputs[1][1])
assert mesh.points.shape == (46, 3) and mesh.hexahedra.shape == (11, 8)
assert mesh.units["stress"] == "lbf/in^2", mesh.units
assert mesh.components["stress"] == ["xx", "yy", "zz", "xy", "yz", "zx"]
assert (mesh.cell_data["plastic_strain"] == 0.125 * np.arange(11)).all()
assert (mesh.point_data["velocity"][:, 1] == -2.0 * np.arange(46)).all()

alive = mesh.cell_data["alive"] != 0
quads, owners = exposed_quads(mesh.hexahedra[alive])
assert len(quads) == 28 + 10, len(quads)
assert len(owners) == len(quads) and owners.max() == 9
corners = mesh.points[quads]
assert abs(volume(corners) - 10 * 0.25**3) < 1e-12, "the normals point outward"

kept, images = mirror_quads(corners, 1e-9)
assert (~kept).sum() == 4 + 2, "the quads in the plane y = 0 are inside the whole body"
assert abs(volume(np.concatenate([corners[kept], images])) - 20 * 0.25**3) < 1e-12

order, outlines, brightness = project(corners, "side")
assert len(order) == 4 + 2 and np.allclose(brightness, 1.0)  # nothing but the cut faces the viewer
order, outlines, brightness = project(corners, "iso")
assert outlines.shape == (len(order), 4, 2) and (brightness >= 0.0).all() and (brightness <= 1.0).all()
assert len(exposed_quads(mesh.hexahedra[:0])[0]) == 0
prisms = np.array([[0, 1, 2, 2, 3, 4, 5, 5], [3, 3, 4, 5, 6, 6, 7, 8]])  # one upon the other, collapsed in two ways
assert len(exposed_quads(prisms)[0]) == 2 * 4, "no lines, and no triangle between the two"

columns, units = read_history(os.path.join(folder, "history.csv"))
assert columns["time"][-1] == 2.5e-5 and units["energy"] == "lbf in"
assert columns["rod_mass_remaining"][0] == 1.0
assert time_scale([0.0, 2.5e-5], "s") == (1e6, "µs")

cut = os.path.join(folder, "cut.vtu")
with open(outputs[0][1], "rb") as whole, open(cut, "wb") as part:
    part.write(whole.read()[:-200])
try:
    read_vtu(cut)
    raise AssertionError("a file cut short was taken")
except BadInput as error:
    assert "cut.vtu" in str(error)
