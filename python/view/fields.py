"""Reads the field output of Pinball: NAME.pvd and its .vtu files (appended raw data, UInt64 headers, hexahedra), or the .pvtu
files of several ranks.

Not a general VTU reader: it takes what solver/output/field_output.cpp writes, and needs NumPy alone.
"""

from __future__ import annotations

import os
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt


class BadInput(Exception):
    """A file or folder that cannot be used as it is; the message is one line for the user."""


TYPES = {"Float32": "<f4", "Float64": "<f8", "UInt8": "u1", "Int32": "<i4", "Int64": "<i8"}

IDS = (("point_data", "GlobalNodeId"), ("cell_data", "GlobalElementId"))  # of a piece: places in the scene


@dataclass
class Mesh:
    """One output time. n nodes, m elements."""

    points: npt.NDArray[Any]  # (n, 3) [length]
    hexahedra: npt.NDArray[Any]  # (m, 8) node indices
    point_data: dict[str, npt.NDArray[Any]] = field(default_factory=dict)  # name: (n,) or (n, components)
    cell_data: dict[str, npt.NDArray[Any]] = field(default_factory=dict)  # name: (m,) or (m, components)
    components: dict[str, list[str]] = field(default_factory=dict)  # name: names of its components, where the file gives them
    names: list[str] = field(default_factory=list)  # of the bodies, where the file gives them
    units: dict[str, str] = field(default_factory=dict)  # quantity ("length", "stress", ...): unit


def part(parent: ElementTree.Element, path: str) -> ElementTree.Element:
    """The first element of a path. Raises ValueError."""
    found = parent.find(path)
    if found is None:
        raise ValueError(f"no {path}")
    return found


def read_units(text: str) -> dict[str, str]:
    """{quantity: unit} from a line "units: in-lbf-s; time [s]; length [in]; ..." somewhere in text."""
    line = re.search(r"units: [^\n]*", text)
    return dict(re.findall(r"; (\w+) \[([^\]]*)\]", line.group())) if line else {}


def read_pvd(path: str) -> list[tuple[float, str]]:
    """[(time, path of the .vtu file), ...] in the order of the list. Raises BadInput."""
    try:
        root = ElementTree.parse(path).getroot()
    except (OSError, ElementTree.ParseError) as error:
        raise BadInput(f"{path}: cannot be read: {error}")
    folder = os.path.dirname(path)
    try:
        return [(float(entry.attrib["timestep"]), os.path.join(folder, entry.attrib["file"])) for entry in root.iter("DataSet")]
    except (KeyError, ValueError) as error:
        raise BadInput(f"{path}: a DataSet without a time and a file ({error})")


def hexahedra_of(connectivity: npt.NDArray[Any], ends: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """(m, 8) node indices; cells of four nodes are tetrahedra, as hexahedra that are collapsed to them."""
    begins = np.concatenate((np.zeros(1, int), ends[:-1]))
    hexahedra = np.empty((len(ends), 8), connectivity.dtype)
    for count, corners in ((8, range(8)), (4, (0, 0, 1, 1, 2, 3, 3, 2))):
        of_count = ends - begins == count
        hexahedra[of_count] = connectivity[begins[of_count, None] + np.array(corners)]
    if not np.isin(ends - begins, (4, 8)).all():
        raise ValueError("cells of other than four or eight nodes")
    return hexahedra


def read_vtu(path: str) -> Mesh:
    """The Mesh of one output time, in the order of the scene: of a .vtu file, or of all pieces of a .pvtu. Raises BadInput where a
    file is missing, cut short or of another kind."""
    return join_pieces(path) if path.endswith(".pvtu") else read_piece(path)


def join_pieces(path: str) -> Mesh:
    """All pieces that a .pvtu file lists, in the order of the scene, which they say of their nodes and elements."""
    try:
        sources = [piece.attrib["Source"] for piece in ElementTree.parse(path).getroot().iter("Piece")]
    except (OSError, KeyError, ElementTree.ParseError) as error:
        raise BadInput(f"{path}: cannot be read: {error}")
    pieces = [read_piece(os.path.join(os.path.dirname(path), source)) for source in sources]
    try:
        nodes, elements = [[getattr(piece, data).pop(name) for piece in pieces] for data, name in IDS]

        def joined(places: list[npt.NDArray[Any]], parts: list[npt.NDArray[Any]]) -> npt.NDArray[Any]:
            whole = np.empty((1 + max(int(place.max()) for place in places), *parts[0].shape[1:]), parts[0].dtype)
            for place, values in zip(places, parts):
                whole[place] = values
            return whole

        first = pieces[0]
        return Mesh(joined(nodes, [piece.points for piece in pieces]),
                    joined(elements, [place[piece.hexahedra].astype(piece.hexahedra.dtype) for place, piece in zip(nodes, pieces)]),
                    {name: joined(nodes, [piece.point_data[name] for piece in pieces]) for name in first.point_data},
                    {name: joined(elements, [piece.cell_data[name] for piece in pieces]) for name in first.cell_data},
                    {name: names for name, names in first.components.items() if name not in dict(IDS).values()}, first.names,
                    first.units)
    except (IndexError, KeyError, ValueError) as error:
        raise BadInput(f"{path}: its pieces do not belong together ({error})")


def read_piece(path: str) -> Mesh:
    """The Mesh in one .vtu file. Raises BadInput as read_vtu."""
    try:
        with open(path, "rb") as file:
            content = file.read()
    except OSError as error:
        raise BadInput(f"{path}: cannot be read: {error.strerror}")
    mark = b'<AppendedData encoding="raw">'
    at = content.find(mark)
    start = content.find(b"_", at + len(mark)) + 1
    if at < 0 or start == 0:
        raise BadInput(f"{path}: not a .vtu file with appended raw data")
    try:
        head = content[:at].decode()
        grid = part(ElementTree.fromstring(head + "</VTKFile>"), "UnstructuredGrid")
        piece = part(grid, "Piece")
        mesh = Mesh(np.empty((0, 3)), np.empty((0, 8), int), units=read_units(head))

        def read_names(tag: ElementTree.Element) -> list[str]:
            begin = start + int(tag.attrib["offset"])
            length = int(np.frombuffer(content, "<u8", 1, begin)[0])
            return content[begin + 8 : begin + 8 + length].decode().split("\0")[:-1]

        def read_array(tag: ElementTree.Element) -> npt.NDArray[Any]:
            begin = start + int(tag.attrib["offset"])
            length = int(np.frombuffer(content, "<u8", 1, begin)[0])
            dtype = np.dtype(TYPES[tag.attrib["type"]])
            values = np.frombuffer(content, dtype, length // dtype.itemsize, begin + 8)
            components = int(tag.get("NumberOfComponents", "1"))
            return values.reshape(-1, components) if components > 1 else values

        for kind, data in (("PointData", mesh.point_data), ("CellData", mesh.cell_data)):
            for tag in part(piece, kind):
                name = tag.attrib["Name"]
                data[name] = read_array(tag)
                count = int(tag.get("NumberOfComponents", "1"))
                mesh.components[name] = [tag.get(f"ComponentName{c}", "xyz"[c : c + 1]) for c in range(count)]
        for tag in grid.iter("DataArray"):
            if tag.get("Name") == "body_names":
                mesh.names = read_names(tag)
        mesh.points = read_array(part(piece, "Points/DataArray"))
        cells = {tag.attrib["Name"]: tag for tag in part(piece, "Cells")}
        mesh.hexahedra = hexahedra_of(*(read_array(cells[name]) for name in ("connectivity", "offsets")))
    except (AttributeError, KeyError, TypeError, ValueError, ElementTree.ParseError) as error:
        raise BadInput(f"{path}: not a file of Pinball's field output, or cut short ({error})")
    return mesh
