"""Two bars: longitudinal waves and the contact of faces that fit, as solver/verification/two_bars.cpp runs them."""

import math

import numpy as np

from .reference import relative, vector, velocity_times
from .study import Quantity, Setup, Study, Sweep
from .variants import PLAIN_TITLE

VELOCITY = 1e-3  # of the first bar: the linear limit, which the exact solution is of
MEETING, DURATION = 5.0, 3.0  # of the contact, and of the comparison in transits of a wave through a bar, which take 1
STATIONS = ("x5", "x10", "x10_5", "x15_5")
BETA = 3.0  # of the scene: without Poisson effect B = E/3, so that this is 1 with the modulus of the bar


def exact(station, tau):
    """Velocity over that of the first bar."""
    start, end = (1.0, 0.0) if station < 2 else (0.0, 1.0)
    meets, leaves = (0.0, 2.0) if station in (1, 2) else (0.5, 1.5)
    return np.where(tau < meets, start, np.where(tau < leaves, 0.5, end))


def setup(elements, variant):
    h, gap = 10.0 / elements, MEETING * VELOCITY
    # The solver takes the bulk viscosity for that of a free cube, whose dilatation it damps three times as much as it
    # damps a bar between planes.
    xi = 0.0 if "element.bulk_viscosity=false" in variant.settings else 3 * 0.06
    settings = ["output.interval=step", f"time.cfl={variant.step / (math.sqrt(1 + xi * xi) - xi)}",
                f"body.bar1.position={vector(-10.0, 0.0, 0.0)}", f"body.bar1.velocity={vector(VELOCITY, 0.0, 0.0)}",
                f"body.bar2.position={vector(gap, 0.0, 0.0)}", f"constraint.2.point={vector(0.0, h, h)}",
                f"constraint.3.point={vector(0.0, h, h)}"]
    for bar in ("bar1", "bar2"):
        settings += [f"body.{bar}.mesh.size={vector(10.0, h, h)}", f"body.{bar}.mesh.elements={vector(elements, 1, 1)}"]
    for station, x in zip(STATIONS, (-5.0, 0.0, gap, gap + 5.0)):
        settings.append(f"probe.{station}.point={vector(x, 0.0, 0.0)}")
    return Setup("two_bars", settings)


def measure(run, elements, variant):
    history = run.history
    tau = velocity_times(history) - MEETING
    dt = history["dt"].copy()
    dt[-1] = 0.0  # no step follows
    among = (tau >= 0) & (tau <= DURATION)
    mean = [float(np.sum(np.abs(history[f"{name}_velocity_x"] / VELOCITY - exact(i, tau))[among] * dt[among])
                  / np.sum(dt[among])) for i, name in enumerate(STATIONS)]
    return {"faces": max(mean[1], mean[2]), "middles": max(mean[0], mean[3]),
            "impulse": relative(history["bar2_velocity_x"][-1] / VELOCITY, 1.0),
            "energy": run.summary["energy"]["balance_error_max"]}


DECADES = [0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0]
STUDY = Study(
    name="two_bars",
    title="Two elastic bars, longitudinal impact",
    reference="exact solution of the wave equation",
    quantities=(
        Quantity("faces", "velocity of the faces", "mean over 3 transits of |v - exact| / v0, the worse of both bars"),
        Quantity("middles", "velocity of the middles", "mean over 3 transits of |v - exact| / v0, the worse of both bars"),
        Quantity("impulse", "impulse", "|impulse / m v0 - 1|"),
        Quantity("energy", "energy balance", "largest error over the initial energy"),
    ),
    groups=("contact", "viscosity off", "step", "precision"),
    mesh="elements of a bar",
    meshes={"full": [10, 20, 40, 80, 160, 320], "quick": [10, 20, 40]},
    report_mesh=10,
    setup=setup,
    measure=measure,
    without=("balls to the face, penalty",),  # the scene's own
    sweeps=(
        Sweep("Penalty factor over that of the scene", "contact.beta",
              {"full": DECADES, "quick": [0.1, 1.0, 10.0]}, (PLAIN_TITLE, "faces, penalty", "slideline, penalty"), 10, BETA),
        Sweep("Damping of the contact, fraction of critical", "contact.damping",
              {"full": [0.0, 0.03, 0.1, 0.3, 1.0], "quick": [0.1, 0.3]}, (PLAIN_TITLE, "faces, penalty"), 10),
    ),
)
