"""The same scene in other units, elsewhere, turned, mirrored, numbered and listed in another way: the same results."""

import math
import os
from collections.abc import Callable
from dataclasses import asdict, dataclass

import numpy as np

from speed_parts import shuffled_mesh

from . import program
from .case import Row
from .judge import ACCURATE, CRASHES, WRONG, at_most
from .scene import Hexahedra, elastic, plastic, scene

SPEED = 0.02
EXACT = 0.0
ROUNDING = 1e-9  # other orders of sums and products: a few roundings (1e-16) a step, enlarged by contacts that begin


def cubes(name, material, counts, position, velocity):
    """A block as a mesh of its own, so that it can be turned, mirrored and renumbered."""
    nodes, elements = shuffled_mesh.block(max(counts))
    nodes = nodes * max(counts)
    inside = np.all(nodes[elements].max(axis=1) <= np.array(counts) + 1e-9, axis=1)
    used = np.unique(elements[inside])
    number = np.full(len(nodes), -1)
    number[used] = np.arange(len(used))
    return {"name": name, "material": material, "mesh": Hexahedra(nodes[used] + position, number[elements[inside]]),
            "velocity": list(velocity)}


def blocks(contact):
    """Two blocks that meet off-centre, so that nothing is symmetric."""
    return scene(30, [elastic()], [cubes("lower", "solid", [3, 3, 2], [0, 0, 0], [0, 0, SPEED]),
                                   cubes("upper", "solid", [2, 3, 3], [0.7, 0.45, 2.5], [0.002, 0.001, -SPEED])],
                 contact=contact, output={"interval": 1.5})


def bar_on_wall():
    return scene(30, [plastic(yield_stress=2e-3, plastic_modulus=1e-2)],
                 [cubes("bar", "solid", [2, 2, 6], [0, 0, 0.25], [0, 0, -SPEED])], element={"bulk_viscosity": True},
                 rigid_wall=[{"point": [0.0, 0.0, 0.0], "normal": [0.0, 0.0, 1.0]}], output={"interval": 1.5})


def spheres():
    def ball(name, position, velocity):
        return {"name": name, "material": "solid", "mesh": {"type": "sphere", "radius": 2.0, "core": 2, "ring": 1},
                "position": position, "velocity": velocity}

    return scene(60, [elastic()], [ball("lower", [0.0, 0.0, 0.0], [0.0, 0.0, SPEED]), ball("upper", [0.7, 0.4, 4.3], [0.0, 0.0, -SPEED])],
                 contact={"method": "pinball", "enforcement": "penalty"}, output={"interval": 3.0})


SCENES = {
    "two blocks, pinball, penalty": lambda: blocks({"method": "pinball", "enforcement": "penalty"}),
    "two blocks, pinball, lagrange": lambda: blocks({"method": "pinball", "enforcement": "lagrange"}),
    "two blocks, slideline, penalty": lambda: blocks({"method": "slideline", "enforcement": "penalty"}),
    "two blocks, slideline, lagrange": lambda: blocks({"method": "slideline", "enforcement": "lagrange"}),
    "plastic bar on a wall": bar_on_wall,
    "two spheres, pinball, penalty": spheres,
}


def changed(made, mesh=None, position=None, velocity=None, **tables):
    """A copy with a function applied to each mesh of its own, position (also of walls) and velocity."""
    new = {**made, **tables, "body": [dict(body) for body in made["body"]],
           "rigid_wall": [dict(wall) for wall in made.get("rigid_wall", [])]}
    for body in new["body"]:
        if isinstance(body["mesh"], Hexahedra):
            body["mesh"] = mesh(body["mesh"]) if mesh else body["mesh"]
        elif position:
            body["position"] = list(position(np.array(body["position"])))
        if velocity:
            body["velocity"] = list(velocity(np.array(body["velocity"])))
    for wall in new["rigid_wall"]:
        if position:
            wall["point"] = list(position(np.array(wall["point"])))
    return new


def in_units(made, length, time, mass):
    """length, time, mass: the old units in terms of the new ones."""
    stress = mass / (length * time**2)
    factors = {"density": mass / length**3, "young_modulus": stress, "yield_stress": stress, "plastic_modulus": stress}
    materials = [{key: item * factors.get(key, 1) if not isinstance(item, str) else item for key, item in material.items()}
                 for material in made["material"]]
    new = changed(made, lambda m: Hexahedra(m.nodes * length, m.elements), lambda x: x * length, lambda v: v * (length / time),
                  material=materials, time={**made["time"], "end": made["time"]["end"] * time},
                  output={"interval": made["output"]["interval"] * time})
    for body in new["body"]:
        if not isinstance(body["mesh"], Hexahedra):
            body["mesh"] = {**body["mesh"], "radius": body["mesh"]["radius"] * length}
    return new


def turned(made, direction):
    """By the shortest rotation of the z axis onto a direction; also the matrix."""
    z = np.array(direction) / np.linalg.norm(direction)
    v, c = np.cross([0, 0, 1], z), z[2]
    cross = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    rotation = np.eye(3) + cross + cross @ cross / (1 + c)
    new = changed(made, lambda m: Hexahedra(m.nodes @ rotation.T, m.elements), lambda x: rotation @ x, lambda v: rotation @ v)
    for body in new["body"]:
        if not isinstance(body["mesh"], Hexahedra):
            body["axis"] = list(z)
    for wall in new["rigid_wall"]:
        wall["normal"] = list(rotation @ wall["normal"])
    return new, rotation


MIRROR = np.diag([-1.0, 1.0, 1.0])
CORNERS_MIRRORED = [1, 0, 3, 2, 5, 4, 7, 6]
QUARTER_TURN = [1, 2, 3, 0, 5, 6, 7, 4]  # of the corners of an element about its zeta axis
ON_ITS_SIDE = [4, 5, 1, 0, 7, 6, 2, 3]  # a quarter turn about xi


def renumbered(mesh):
    """Nodes and elements at random, each element beginning at a corner at random."""
    nodes, elements = shuffled_mesh.shuffle(mesh.nodes, np.array(mesh.elements), seed=3)
    random = np.random.default_rng(4)
    for corners in elements:
        for turn, most in ((QUARTER_TURN, 4), (ON_ITS_SIDE, 4), (QUARTER_TURN, 4)):
            for _ in range(random.integers(most)):
                corners[:] = corners[turn]
    return Hexahedra(nodes, elements)


def with_unused(mesh):
    return Hexahedra(np.vstack([mesh.nodes, [[1e9, 2e9, 3e9], [0, 0, 0]]]), mesh.elements)


def columns(run, made, rotation=np.eye(3)):
    """What is compared, without dimension: all of the history that does not depend on the frame, and the velocities."""
    h, total = run.history, run.history["total"][0]
    speed = max(np.linalg.norm(body["velocity"]) for body in made["body"])
    found = [h["time"] / made["time"]["end"]]
    found += [h[name] / total for name in ("kinetic", "kinetic_below_zero", "internal", "hourglass", "bulk_viscosity", "contact_stored", "contact_damped",
                                           "external")]
    for body in sorted(body["name"] for body in made["body"]):
        v = np.array([h[f"{body}_velocity_{axis}"] for axis in "xyz"]) / speed
        found += list(rotation.T @ v if rotation is not None else v)
    return np.array(found)


@dataclass
class Invariance:
    """A scene and another form of it. rotation: from the one to the other."""
    title: str
    made: dict
    other: dict
    tolerance: float
    rotation: np.ndarray | None = None
    threads: int = 1
    hash: Callable = staticmethod(lambda run: None)  # of runs whose bits are compared
    group = "invariance"
    slow = False

    def row(self, folder):
        first = program.run(self.made, os.path.join(folder, "first"))
        second = program.run(self.other, os.path.join(folder, "second"), threads=self.threads)
        seconds = first.seconds + second.seconds
        if first.status or second.status:
            return Row(self.group, self.title, CRASHES, False, first.message or second.message or second.said[-200:], seconds=seconds)
        a, b = columns(first, self.made), columns(second, self.other, self.rotation)
        deviation = float(np.abs(a - b).max()) if a.shape == b.shape else math.inf
        figures = [at_most("largest difference", deviation, self.tolerance),
                   at_most("difference of the number of steps", abs(first.summary["steps"] - second.summary["steps"]), 0)]
        if self.hash(first) != self.hash(second):
            figures.append(at_most("states that are not the same to the bit", 1, 0))
        right = all(figure.holds for figure in figures)
        worst = next((figure for figure in figures if not figure.holds), figures[0])
        return Row(self.group, self.title, ACCURATE if right else WRONG, right, worst.text(),
                   [{**asdict(figure), "holds": figure.holds} for figure in figures], first.summary["steps"], seconds, (ACCURATE,))


def of_scene(name, make):
    made = make()
    own_meshes = all(isinstance(body["mesh"], Hexahedra) for body in made["body"])

    def form(title, other, tolerance, rotation=None, **more):
        return Invariance(f"{name}: {title}", made, other, tolerance, rotation, **more)

    # Powers of two change no digit of a product or a square root of even powers, so that every number of the run has the
    # same digits. The third root for radii keeps them too where 3 divides the power of a length and it is negative (that of
    # the C library treats positive and negative exponents in two ways).
    found = [form("units of 2^-18 lengths, 2^-17 times, 2^13 masses", in_units(made, 2.0**-18, 2.0**-17, 2.0**13), EXACT)]
    for factor in (1e-6, 1e6):
        found += [form(f"unit of {what} x {factor:g}", in_units(made, **{"length": 1.0, "time": 1.0, "mass": 1.0, what: factor}), ROUNDING)
                  for what in ("length", "time", "mass")]
    # Coordinates of 1e6 lengths h keep 1e-10 h; strains of 1e-2 then have 8 digits, and fewer where contact begins.
    away = np.array([1e6, -2e6, 0.5e6])
    found.append(form("moved by 1e6 lengths", changed(made, lambda m: Hexahedra(m.nodes + away, m.elements), lambda x: x + away), 1e-6))
    for direction in ([0.3, -0.5, 0.8], [1.0, 2.0, -0.4], [-0.9, 0.1, 0.05]):
        other, rotation = turned(made, direction)
        found.append(form(f"turned, z axis to {direction}", other, ROUNDING, rotation))
    if len(made["body"]) > 1:
        found.append(form("bodies in the other order", {**made, "body": made["body"][::-1]}, ROUNDING))
    if own_meshes:
        mirrored = changed(made, lambda m: Hexahedra(m.nodes @ MIRROR, np.array(m.elements)[:, CORNERS_MIRRORED]),
                           lambda x: MIRROR @ x, lambda v: MIRROR @ v)
        found += [form("mirrored", mirrored, ROUNDING, MIRROR),
                  form("nodes, elements and their corners renumbered", changed(made, renumbered), ROUNDING),
                  form("unused nodes in the mesh files", changed(made, with_unused), EXACT, hash=lambda run: run.summary["state_hash"])]
    found.append(form("two threads", made, EXACT, threads=2, hash=lambda run: run.summary["state_hash"]))
    return found


def cases(form):
    names = list(SCENES) if form == "full" else list(SCENES)[:2] + ["plastic bar on a wall"]
    return [case for name in names for case in of_scene(name, SCENES[name])]
