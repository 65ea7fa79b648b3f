"""Materials at the ends of their ranges."""

import math

import numpy as np

from .case import EITHER, Case
from .judge import ACCURATE, REFUSES, STOPS, WARNS, Figure
from .scene import block, elastic, plastic, scene
from .time_step import breathing, energy_is_bounded

POISSON = (-0.9, 0.0, 0.3, 0.45, 0.49, 0.499, 0.4999)
SHEAR = np.array([[0, 1, 0], [1, 0, 0], [0, 0, 0]])


def poisson_ratios():
    """A cube of one element: w^2 = 12 K in dilatation, 8 G in shear (density and edge 1)."""
    found = []
    for nu in POISSON:
        bulk, shear = 1 / (3 * (1 - 2 * nu)), 1 / (2 * (1 + nu))
        material = elastic(poisson=nu)
        found += [breathing(f"{nu}: a cube breathes", "Poisson ratio", material, [1, 1, 1], np.eye(3), math.sqrt(12 * bulk), 0.05),
                  breathing(f"{nu}: a cube in shear", "Poisson ratio", material, [1, 1, 1], SHEAR, math.sqrt(8 * shear), 0.05),
                  Case("Poisson ratio", f"{nu}: 4 x 4 x 4 elements in all modes, 20,000 steps",
                       scene(1e9, [material], [block("body", [4] * 3, [4] * 3, velocity_noise=1e-5)], steps=20_000,
                             output={"interval": 10.0}), figures=energy_is_bounded)]
    found += [Case("Poisson ratio", f"{nu}", scene(1, [elastic(poisson=nu)], [block("body", [1] * 3, [1] * 3)]), (REFUSES,))
              for nu in (0.5, -1.0, 0.6)]
    return found


SPEED, TIME = 1e-4, 500.0


def pulled(material):
    """One element in uniaxial strain, by prescribed velocities of all its nodes."""
    return scene(TIME, [material], [block("body", [1] * 3, [1] * 3)],
                 prescribed_velocity=[{"velocity": [0, 0, SPEED], "plane": {"point": [0, 0, 1], "normal": [0, 0, 1]}},
                                      {"velocity": [0, 0, 0], "plane": {"normal": [0, 0, 1]}}],
                 probe=[{"name": "p", "kind": "element", "point": [0.5, 0.5, 0.5], "quantities": ["stress", "plastic_strain"]}])


def exact_stress(material):
    """(axial stress, plastic strain) in uniaxial strain e: p = (2 G e - Y) / (3 G + H), s = K e + 2/3 (Y + H p)."""
    nu, young = material["poisson_ratio"], material["young_modulus"]
    bulk, shear = young / (3 * (1 - 2 * nu)), young / (2 * (1 + nu))
    e, yielding, hardening = math.log(1 + SPEED * TIME), material["yield_stress"], material["plastic_modulus"]
    p = (2 * shear * e - yielding) / (3 * shear + hardening)
    flow = yielding + hardening * p
    if "ultimate_stress" in material and flow > material["ultimate_stress"]:
        flow = material["ultimate_stress"]
        p = (2 * shear * e - flow) / (3 * shear)
    return bulk * e + 2 / 3 * flow, p


def yields(title, material):
    stress, strain = exact_stress(material)

    def figures(run):
        return [Figure("axial stress / exact", run.history["p_stress_zz"][-1] / stress, 1.0, 1e-5),
                Figure("plastic strain / exact", run.history["p_plastic_strain"][-1] / strain, 1.0, 1e-5)]

    return Case("plasticity", title, pulled(material), figures=figures)


def plasticity():
    return [
        yields("hardening modulus 0", plastic()),
        yields("hardening modulus 0, Poisson ratio 0.4999", plastic(poisson=0.4999)),
        yields("hardening modulus 1000 E", plastic(plastic_modulus=1e3)),
        yields("ultimate stress = yield stress", plastic(plastic_modulus=1.0, ultimate_stress=1e-3)),
        yields("yield stress 1e-12 E", plastic(yield_stress=1e-12)),
        yields("yield stress 1e-300 E", plastic(yield_stress=1e-300)),
        Case("plasticity", "yield stress 0", pulled(plastic(yield_stress=0.0)), (REFUSES,)),
        Case("plasticity", "yield stress 1e-12 E, a free block in all modes",
             scene(1e9, [plastic(yield_stress=1e-12)], [block("body", [3] * 3, [3] * 3, velocity_noise=1e-3)], steps=2000,
                   output={"interval": 1.0}), (*EITHER, WARNS)),  # of internal energy below zero, which is true
    ]


def extremes():
    """Numbers at the ends of what double and single precision hold: nodes without mass, moduli that overflow."""
    def free(material, **more):
        return scene(1, [material], [block("body", [2] * 3, [2] * 3, velocity_noise=1e-3)], steps=100, **more)

    allowed = (ACCURATE, STOPS, REFUSES)
    return [Case("ends of the range", title, free(material, **more), allowed) for title, material, more in (
        ("density 1e-310 (nodes without mass)", elastic(density=1e-310), {}),
        ("density 1e-42, single precision (nodes without mass)", elastic(density=1e-42), {"precision": "float"}),
        ("density 1e300", elastic(density=1e300), {}),
        ("density 1e38, single precision", elastic(density=1e38), {"precision": "float"}),
        ("Young's modulus 1e300", elastic(young=1e300), {}),
        ("Young's modulus 1e-300", elastic(young=1e-300), {}),
        ("Young's modulus 1e38, single precision", elastic(young=1e38), {"precision": "float"}))]


def cases(form):
    return poisson_ratios() + plasticity() + extremes()
