"""Scenes as Python tables, and the files that the program reads."""

import json
import os
from dataclasses import dataclass

import numpy as np

from speed_parts import shuffled_mesh


@dataclass
class Hexahedra:
    """A mesh of its own, in the place of a generated one: written as a file of Gmsh beside the scene."""
    nodes: np.ndarray
    elements: np.ndarray  # 8 numbers of nodes, from 0

    def write(self, path):
        shuffled_mesh.write_gmsh(path, np.asarray(self.nodes, dtype=float), np.asarray(self.elements))


def value(item):
    """As TOML. Numbers keep all their digits."""
    if isinstance(item, (bool, str)):
        return json.dumps(item)
    if isinstance(item, (int, np.integer)):
        return str(int(item))
    if isinstance(item, (float, np.floating)):
        return repr(float(item))
    if isinstance(item, dict):
        return "{ " + ", ".join(f"{key} = {value(part)}" for key, part in item.items()) + " }"
    return "[" + ", ".join(value(part) for part in item) + "]"


def toml(scene):
    """A scene of plain keys, tables (dict) and arrays of tables (list of dict)."""
    lines = [f"{key} = {value(item)}" for key, item in scene.items() if not isinstance(item, (dict, list))]
    for name, item in scene.items():
        for table in item if isinstance(item, list) else [item] if isinstance(item, dict) else []:
            lines += ["", f"[[{name}]]" if isinstance(item, list) else f"[{name}]"]
            lines += [f"{key} = {value(part)}" for key, part in table.items()]
    return "\n".join(lines) + "\n"


def write(scene, folder, name="scene"):
    """Writes the scene and its meshes; returns the path of the scene."""
    os.makedirs(folder, exist_ok=True)
    bodies = []
    for body in scene.get("body", []):
        if isinstance(body["mesh"], Hexahedra):
            file = f"{name}_{body['name']}.msh"
            body["mesh"].write(os.path.join(folder, file))
            body = {**body, "mesh": {"type": "gmsh", "file": file}}
        bodies.append(body)
    path = os.path.join(folder, f"{name}.toml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(toml({**scene, "body": bodies}))
    return path


def elastic(name="solid", density=1.0, young=1.0, poisson=0.3):
    return {"name": name, "model": "elastic", "density": density, "young_modulus": young, "poisson_ratio": poisson}


def plastic(name="solid", yield_stress=1e-3, plastic_modulus=0.0, **more):
    extra = {key: more.pop(key) for key in ("erosion_strain", "ultimate_stress") if key in more}
    return {**elastic(name, **more), "model": "von_mises", "yield_stress": yield_stress, "plastic_modulus": plastic_modulus, **extra}


def block(name, size, elements, material="solid", **more):
    return {"name": name, "material": material, "mesh": {"type": "block", "size": list(size), "elements": list(elements)}, **more}


def scene(end, materials, bodies, contact=None, cfl=0.9, steps=None, element=None, **more):
    """One of the suite: without bulk viscosity unless it asks for it, so that nothing hides energy."""
    tables = {"title": "stress", "units": "none", "time": {"end": float(end), "cfl": float(cfl)},
              "element": {"bulk_viscosity": False, **(element or {})}}
    if steps:
        tables["time"]["steps"] = int(steps)
    if contact:
        tables["contact"] = contact
    return {**tables, "material": materials, "body": bodies, **more}


def hexahedron(*corners):
    """A body of one element."""
    return Hexahedra(np.array(corners, dtype=float), np.arange(8).reshape(1, 8))


CUBE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], dtype=float)
