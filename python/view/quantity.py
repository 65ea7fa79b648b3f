"""A field of the output reduced to one number per element or node, with its name and unit."""

import numpy as np

from view.fields import BadInput
from view.labels import readable_powers, with_unit

QUANTITIES = {"velocity": "velocity", "contact_force": "force", "stress": "stress", "pinball_radius": "length",
              "von_mises": "stress", "displacement": "length", "pressure": "stress"}
SIGNED = {"pressure"}  # beside components
LABELS = {"von_mises": "von Mises stress", "plastic_strain": "effective plastic strain"}


def default_field(meshes):
    """What shows most of a run: plastic strain where there is any, else stress, else motion."""
    strained = any("plastic_strain" in m.cell_data and (m.cell_data["plastic_strain"][shown(m)] > 0.0).any() for m in meshes)
    if strained:
        return "plastic_strain"
    for name in ("von_mises", "velocity"):
        if name in meshes[0].cell_data or name in meshes[0].point_data:
            return name
    return "body"


def shown(mesh):
    """Mask of the elements that are there: not eroded, with corners that are numbers."""
    alive = np.isfinite(mesh.points).all(axis=1)[mesh.hexahedra].all(axis=1)
    if "alive" in mesh.cell_data:
        alive &= mesh.cell_data["alive"] != 0
    return alive


class Quantity:
    """The value itself, a named component, or the magnitude of a vector."""

    def __init__(self, name, mesh):
        arrays = {**mesh.point_data, **mesh.cell_data}
        base, _, component = name.rpartition("_")
        self.name, self.component = name, None
        if name not in arrays and base in arrays and component in mesh.components[base]:
            self.name, self.component = base, mesh.components[base].index(component)
        elif name not in arrays or name == "stress":
            known = [n for n in arrays if n not in ("stress", "alive")]
            known += [f"{n}_{c}" for n in arrays if arrays[n].ndim > 1 for c in mesh.components[n]]
            raise BadInput(f"no field {name} in the output; there are: {', '.join(known)}")
        self.title = name
        # As ParaView names them: those of the file, else X, Y, Z.
        self.components = []
        if arrays[self.name].ndim > 1:
            self.components = [c.upper() if len(c) == 1 else c for c in mesh.components[self.name]]
        self.on_points = self.name in mesh.point_data
        is_component = self.component is not None
        self.signed = is_component or self.name in SIGNED
        self.letters = component if is_component else ""  # "x", "xy"
        unit = mesh.units.get(QUANTITIES.get(self.name), "")
        label = LABELS.get(self.name, self.name.replace("_", " "))
        self.label = readable_powers(with_unit(f"{label} {component}" if is_component else label, unit))

    def of(self, mesh):
        """(n,) or (m,) values of the nodes or elements of a mesh."""
        values = (mesh.point_data if self.on_points else mesh.cell_data)[self.name].astype(float)
        if self.component is not None:
            return values[:, self.component]
        return np.linalg.norm(values, axis=1) if values.ndim > 1 else values

    def changes_sign(self, axes):
        """Whether the mirror image at planes across some axes ("x", "xy") has the opposite value."""
        return sum(self.letters.count(axis) for axis in axes) % 2 == 1
