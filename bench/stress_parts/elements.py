"""Shapes of elements: slender, flat, distorted, inverted at the start or on the way; meshes that cannot be."""

import numpy as np

from .case import EITHER, Case
from .judge import ACCURATE, REFUSES, STOPS, WARNS
from .scene import CUBE, Hexahedra, block, elastic, hexahedron, scene
from .time_step import breathing, energy_is_bounded
from speed_parts import shuffled_mesh

ASPECTS = (1, 10, 100, 1000)
Z, X = np.diag([0, 0, 1]), np.diag([1, 0, 0])


def aspect_ratios():
    found = []
    for a in ASPECTS:
        for name, size in ((f"1 : 1 : {a}", [1, 1, a]), (f"{a} : {a} : 1", [a, a, 1])):
            for axis, gradient in (("z", Z), ("x", X)):
                length = size[2] if axis == "z" else size[0]
                # Steps short beside the period: central differences are late by (w dt)^2 / 24.
                cfl = 0.05 if length == min(size) else 0.5
                found.append(breathing(f"one element {name} breathes along {axis}", "aspect ratio", elastic(poisson=0.0), size,
                                       gradient, 2.0 / length, cfl))
        if a > 1:
            found += [Case("aspect ratio", f"3 x 3 x 3 elements {name} in all modes, 20,000 steps",
                           scene(1e12, [elastic()], [block("body", [3 * s for s in size], [3, 3, 3], velocity_noise=1e-5)], steps=20_000,
                                 output={"interval": 40.0}), figures=energy_is_bounded)
                      for name, size in ((f"1 : 1 : {a}", [1, 1, a]), (f"{a} : {a} : 1", [a, a, 1]))]
    return found


def pushed_in(fraction):
    """2 x 2 x 2 cubes, the inner node pushed towards a corner by this part of an edge."""
    nodes, elements = shuffled_mesh.block(2)
    nodes = 2 * nodes
    nodes[np.all(nodes == 1, axis=1)] -= fraction
    return Hexahedra(nodes, elements)


def distorted():
    def vibrates(title, mesh, expected=(ACCURATE,)):
        return Case("distorted elements", title,
                    scene(1e12, [elastic()], [{"name": "body", "material": "solid", "mesh": mesh, "velocity_noise": 1e-5}],
                          steps=20_000, output={"interval": 20.0}), expected, energy_is_bounded)

    found = [vibrates(f"inner node pushed in by {fraction} h (corners invert at 1/3), 20,000 steps", pushed_in(fraction),
                      (ACCURATE,) if fraction < 1 / 3 else (ACCURATE, STOPS, REFUSES)) for fraction in (0.3, 0.333, 0.34, 0.5, 0.9)]
    for t in (1e-3, 1e-6, 1e-9):
        body = block("body", [1, 1, [1.0, t, 1.0]], [1, 1, [1, 1, 1]], velocity_gradient=[[0, 0, 0], [0, 0, 0], [0, 0, 1e-3]])
        found.append(Case("distorted elements", f"a layer of thickness {t:g} h between two of h, 5,000 steps",
                          scene(1e12, [elastic()], [body], steps=5000, output={"interval": 1000 * t})))
    for t in (1e-13, 0.0):
        found.append(Case("distorted elements", f"an element of thickness {t:g} h",
                          scene(1, [elastic()], [{"name": "body", "material": "solid", "mesh": hexahedron(*(CUBE * [1, 1, t]))}]),
                          (REFUSES,)))
    return found


def impossible_meshes():
    def refused(title, mesh, **more):
        return Case("impossible meshes", title, scene(1, [elastic()], [{"name": "body", "material": "solid", "mesh": mesh, **more}]),
                    (REFUSES,))

    huge = 1_000_000
    return [
        refused("an element inside out", hexahedron(*CUBE[[4, 5, 6, 7, 0, 1, 2, 3]])),
        refused("all eight nodes at one place (nodes without mass)", hexahedron(*(CUBE * 0))),
        refused("all eight corners are one node", Hexahedra(CUBE, np.zeros((1, 8), dtype=int))),
        refused("a node that is not there", Hexahedra(CUBE, np.array([[0, 1, 2, 3, 4, 5, 6, 99]]))),
        refused("coordinates of 1e200, volumes that overflow", hexahedron(*(CUBE * 1e200))),
        refused("coordinates of 1e-200, volumes that underflow", hexahedron(*(CUBE * 1e-200))),
        refused("10^18 elements in a block", {"type": "block", "size": [1, 1, 1], "elements": [huge] * 3}),
        refused("10^9 elements in a block", {"type": "block", "size": [1, 1, 1], "elements": [1000] * 3}),
        refused("2 x 10^9 elements in a row", {"type": "block", "size": [1, 1, 1], "elements": [1, 1, 2_000_000_000]}),
        refused("10^18 elements in a sphere", {"type": "sphere", "radius": 1, "core": huge}),
        refused("4 x 10^8 elements in a cylinder", {"type": "cylinder", "radius": 1, "length": 1, "core": 100, "layers": 28_000}),
        refused("10^9 layers in a rod", {"type": "round_nosed_rod", "length": 2, "radius": 1, "layers": 1_000_000_000}),
    ]


def pressed(elements, policy=None):
    """The upper face driven through the lower one, which is held, in one unit of time: flat at t = 1."""
    n = elements[2]
    return scene(3, [elastic()], [block("body", elements, elements)], element={"negative_volume": policy} if policy else None,
                 prescribed_velocity=[{"velocity": [0, 0, -n], "plane": {"point": [0, 0, n], "normal": [0, 0, 1]}},
                                      {"velocity": [0, 0, 0], "plane": {"normal": [0, 0, 1]}}])


def inverting():
    def free(**motion):
        return scene(50, [elastic()], [block("body", [3, 3, 3], [3, 3, 3], **motion)])

    group, name = "elements that invert", r"element \d+ of body"
    squeezed = {"velocity_gradient": [[-2.0, 0, 0], [0, -2.0, 0], [0, 0, -2.0]]}
    return [
        Case(group, "one element pressed through itself", pressed([1, 1, 1]), (STOPS,), named=name),
        Case(group, "3 x 3 x 3 elements pressed through themselves", pressed([3, 3, 3]), (STOPS,), named=name),
        Case(group, "one element pressed through itself, eroded there", pressed([1, 1, 1], "erode"), (ACCURATE, WARNS, STOPS)),
        Case(group, "3 x 3 x 3 elements pressed through themselves, eroded there", pressed([3, 3, 3], "erode"), (ACCURATE, WARNS, STOPS)),
        Case(group, "a free block that implodes", free(**squeezed), EITHER),
        Case(group, "a free block with random velocities of the wave speed", free(velocity_noise=1.0), EITHER),
        Case(group, "a free block with random velocities of ten wave speeds", free(velocity_noise=10.0), EITHER),
    ]


def cases(form):
    found = aspect_ratios() + distorted() + impossible_meshes() + inverting()
    return [case for case in found if form == "full" or not case.slow]
