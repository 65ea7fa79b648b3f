"""Cantilever: bending, which elements of uniform strain resist by hourglass control alone. As
solver/verification/beam.cpp runs it, at rest after two periods of critical damping."""

import math

import numpy as np

from .reference import probe, vector
from .study import Quantity, Setup, Study
from .variants import PLAIN_TITLE

YOUNG, POISSON, FORCE = 1.0, 0.3, 2.5e-7
LENGTH = 10.0


def timoshenko():
    """Deflection of the beam of height and width 1, shear factor 5/6."""
    return FORCE * LENGTH**3 / (3 * YOUNG / 12) + FORCE * LENGTH / (5 / 6 * YOUNG / (2 * (1 + POISSON)))


def coefficient(variant):
    """Of the hourglass stiffness, for the frequency that is damped; forms without it bend about as they should."""
    exact = YOUNG / (3 * (1 - POISSON) * YOUNG / ((1 + POISSON) * (1 - 2 * POISSON)))
    if any(s.startswith("element.hourglass=") for s in variant.settings):
        return exact, exact
    given = [float(s.split("=")[1]) for s in variant.settings if s.startswith("element.hourglass_coefficient=")]
    return (given or [0.05])[0], exact


def setup(layers, variant):
    given, exact = coefficient(variant)
    softer = 1 / (1 - 1 / layers**2 + given / exact / layers**2)
    frequency = 3.516 / LENGTH**2 * math.sqrt(YOUNG / (12 * softer))
    end = 4 * math.pi / frequency
    probes = "".join(probe(f"end_{i}_{side}", "beam", (LENGTH, i / layers, float(side)), "displacement")
                     for i in range(layers + 1) for side in (0, 1))
    return Setup("cantilever", [f"body.beam.mesh.elements={vector(10 * layers, layers, 1)}", f"damping.mass={2 * frequency}",
                                f"time.end={end}", f"output.interval={end}", f"time.cfl={variant.step}"],
                 more=probes, replace=(("hourglass_coefficient = 0.05\n", ""),))  # the default of the form


def measure(run, layers, variant):
    history = run.history
    deflection = np.mean([history[f"end_{i}_{side}_displacement_y"][-1] for i in range(layers + 1) for side in (0, 1)])
    return {"deflection": float(abs(deflection / timoshenko() - 1))}


STUDY = Study(
    name="cantilever",
    title="Cantilever of length 10 times its height, Poisson ratio 0.3",
    reference="deflection of the Timoshenko beam, shear factor 5/6; enhanced strain elements reach it to 0.1 % "
              "(data/reference/cantilever_ratio.csv)",
    quantities=(Quantity("deflection", "deflection of the end at rest", "|w / w_Timoshenko - 1|"),),
    groups=("hourglass", "step", "precision"),
    mesh="elements over the height",
    meshes={"full": [1, 2, 4, 8], "quick": [1, 2]},
    report_mesh=4,
    fine={"full": 4},
    foremost=(PLAIN_TITLE, "assumed strain", "float"),
    setup=setup,
    measure=measure,
    note="Viscous hourglass control gives no stiffness at all to a single layer; where it creeps on, the error is that at "
         "the end of the run.",
)
