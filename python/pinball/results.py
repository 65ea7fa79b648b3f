"""What a run has left in its folder, as arrays: history.csv and field output."""

from __future__ import annotations

import csv
import json
import os
import pathlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from ._core import InputError
from .field_files import BadInput, Mesh, read_pvd, read_vtu

if TYPE_CHECKING:
    import pandas
    import xarray


@dataclass(frozen=True)
class History(Mapping[str, npt.NDArray[Any]]):
    """The rows of history.csv: arrays (rows,) by the names of the columns, `time` among them."""

    columns: dict[str, npt.NDArray[Any]] = field(repr=False)
    units: dict[str, str]  # of quantities ("time", "energy", ...), as far as the scene names them

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        return self.columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def to_pandas(self) -> pandas.DataFrame:
        """With the time as index, and the units as `attrs["units"]`. Raises ImportError where pandas is not there."""
        import pandas

        frame = pandas.DataFrame(self.columns).set_index("time")
        frame.attrs["units"] = self.units
        return frame


@dataclass(frozen=True)
class Fields:
    """Field output at t times of n nodes and m elements, in the order of the scene. What is not a number is nan."""

    times: npt.NDArray[Any]  # (t,) [time]
    positions: npt.NDArray[Any] = field(repr=False)  # (t, n, 3) [length]
    hexahedra: npt.NDArray[Any] = field(repr=False)  # (m, 8) node numbers; of a tetrahedron collapsed: 0 0 1 1 2 3 3 2
    of_nodes: dict[str, npt.NDArray[Any]] = field(repr=False)  # (t, n) or (t, n, components): velocity, ...
    of_elements: dict[str, npt.NDArray[Any]] = field(repr=False)  # (t, m) or (t, m, components): stress, plastic_strain, alive, ...
    components: dict[str, list[str]] = field(repr=False)  # of the fields that have some: stress: xx, yy, ...
    bodies: list[str]  # names; the field `body` has their numbers
    units: dict[str, str]  # of quantities, as far as the scene names them

    def to_xarray(self) -> xarray.Dataset:
        """Of all fields, along time, node, element, axis and the components of each, with `position` among them and the units as
        attributes. Raises ImportError where xarray is not there."""
        import xarray

        variables: dict[str, Any] = {"position": (("time", "node", "axis"), self.positions),
                                     "hexahedra": (("element", "corner"), self.hexahedra)}
        coordinates: dict[str, Any] = {"time": self.times, "axis": ["x", "y", "z"]}
        for place, arrays in (("node", self.of_nodes), ("element", self.of_elements)):
            for name, values in arrays.items():
                dimensions = ["time", place]
                if values.ndim == 3:
                    names = self.components[name]
                    dimensions.append("axis" if names == ["x", "y", "z"] else f"{name}_component")
                    coordinates.setdefault(dimensions[-1], names)
                variables[name] = (dimensions, values)
        return xarray.Dataset(variables, coordinates, {"bodies": self.bodies, "units": json.dumps(self.units)})


def units_of(folder: pathlib.Path) -> dict[str, str]:
    """As summary.json has them; none where that is not there."""
    try:
        units = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["unit_names"]
        return {quantity: unit for quantity, unit in units.items() if unit}
    except (OSError, ValueError, KeyError, AttributeError):
        return {}


def read_history(out: str | os.PathLike[str]) -> History:
    """The history of a run, also of one that goes on, from its folder. Raises InputError where there is none."""
    folder = pathlib.Path(out)
    try:
        with open(folder / "history.csv", encoding="utf-8", newline="") as file:
            names, *rows = csv.reader(file)
        if any(len(row) != len(names) for row in rows):
            raise ValueError("a row is cut off")
        numbers = np.array([[float(cell) for cell in row] for row in rows]).reshape(len(rows), len(names))
    except OSError as error:
        raise InputError(f"read_history: {folder / 'history.csv'} ({error.strerror}): expected the folder of a run") from None
    except ValueError as error:
        raise InputError(f"read_history: {folder / 'history.csv'} ({error}): expected the history of a run") from None
    return History({name: numbers[:, i] for i, name in enumerate(names)}, units_of(folder))


def read_fields(out: str | os.PathLike[str]) -> Fields:
    """All field output of a run (`output.field_interval`, `field_times`) from its folder, read into memory. Raises InputError where there
    is none, or a file cannot be read."""
    folder = pathlib.Path(out)
    try:
        entries = read_pvd(str(folder / "fields.pvd"))
        meshes: list[Mesh] = [read_vtu(path) for _, path in entries]
    except BadInput as error:
        raise InputError(f"read_fields: {error}") from None
    if not meshes:
        raise InputError(f"read_fields: {folder / 'fields.pvd'}: expected at least one time")
    last = meshes[-1]

    def over_time(kind: str) -> dict[str, npt.NDArray[Any]]:
        return {name: np.stack([getattr(mesh, kind)[name] for mesh in meshes]) for name in getattr(last, kind)}

    return Fields(np.array([time for time, _ in entries]), np.stack([mesh.points for mesh in meshes]), last.hexahedra,
                  over_time("point_data"), over_time("cell_data"),
                  {name: names for name, names in last.components.items() if len(names) > 1}, list(last.names), units_of(folder))
