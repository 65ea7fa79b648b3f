"""Newton's cradle of elastic bars: does contact keep energy over several impacts?"""

import numpy as np

from .reference import vector
from .study import Quantity, Setup, Study, Sweep
from .two_bars import BETA
from .variants import PLAIN_TITLE

BARS, SPEED = 5, 0.1


def setup(elements, variant):
    h = 10.0 / elements
    settings = [f"contact.beta={BETA}", "contact.radius_factor=0.8059959770082347",  # as the scene's variant by penalty
                f"time.cfl={variant.step}", *(f"constraint.{plane}.point={vector(0.0, h, h)}" for plane in (2, 3))]
    for bar in range(1, BARS + 1):
        settings += [f"body.bar{bar}.mesh.size={vector(10.0, h, h)}", f"body.bar{bar}.mesh.elements={vector(elements, 1, 1)}"]
    return Setup("newtons_cradle", settings)


def measure(run, elements, variant):
    bodies = run.summary["bodies"]
    velocity = np.array([b["velocity"][0] for b in bodies]) / SPEED
    energy = run.summary["energy"]
    initial = energy["initial_total"]
    kept = 0.5 * bodies[-1]["mass_initial"] * bodies[-1]["velocity"][0] ** 2 / initial
    elastic = (energy["kinetic"] + energy["internal"] + energy["contact_stored"]) / initial
    return {"velocities": float(np.max(np.abs(velocity - np.eye(BARS)[-1]))), "kept": float(abs(1 - kept)),
            "lost": float(abs(1 - elastic)), "energy": energy["balance_error_max"]}


STUDY = Study(
    name="newtons_cradle",
    title="Newton's cradle of five elastic bars",
    reference="exact: the last bar has the velocity of the first one, all others rest",
    quantities=(
        Quantity("velocities", "velocities after four impacts", "largest |v - exact| / v0 of a bar"),
        Quantity("kept", "energy of the last bar", "|1 - its kinetic energy as a rigid body / the initial energy|"),
        Quantity("lost", "elastic and kinetic energy", "|1 - at the end / the initial energy|"),
        Quantity("energy", "energy balance", "largest error over the initial energy"),
    ),
    groups=("contact", "viscosity on", "step", "precision"),
    mesh="elements of a bar",
    meshes={"full": [10, 20, 40, 80], "quick": [10, 20]},
    report_mesh=10,
    setup=setup,
    measure=measure,
    without=("balls to the face, penalty",),  # that of the scene's variant
    sweeps=(Sweep("Penalty factor over that of the scene", "contact.beta", {"full": [0.1, 0.3, 1.0, 3.0, 10.0], "quick": [1.0]},
                  (PLAIN_TITLE, "faces, penalty", "slideline, penalty"), 10, BETA),),
)
