"""A block drawn over a flat floor of another mesh: bumps of the floor, and the force that resists without friction."""

import numpy as np

from .study import Quantity, Setup, Study, Sweep
from .variants import PLAIN_TITLE

SIZE = 0.1  # of an element of the floor, before refinement [m]
SPEED, LOAD, DAMPING = 10.0, 1.0e6, 500.0
REST = 10.0e-3  # from here on the slider has settled [s]
FRICTION = 0.3
FINE = (PLAIN_TITLE, "faces, penalty", "faces, projection")


def halo(variant, refine):
    """Height at which the slider begins: balls reach out of the faces, unless they are smaller."""
    own = dict(s.split("=", 1) for s in variant.settings)
    balls = own.get("contact.gap", "pinball") == "pinball" and own.get("contact.method") != "slideline"
    return (0.022 if balls and "contact.radius_factor" not in own else 1e-4) / refine


def setup(refine, variant):
    height = halo(variant, refine)
    settings = [f"body.slider.position=[-0.12, -0.12, {height}]", f"time.cfl={variant.step}"]
    corners = [(x, y) for y in (-0.12, 0.12) for x in (-0.12, 0.12)]
    settings += [f"probe.top_{i}.point=[{x}, {y}, {0.16 + height}]" for i, (x, y) in enumerate(corners)]
    return Setup("sliding_block", settings, refine=refine)


def forces(run):
    """(times, tangential force of the contact): the work done from outside is that of the load, of what draws the block
    and of the damping; the damping's is 2 a times the kinetic energy, its force on the block a m v."""
    history = run.history
    times = history["time"]
    mass = next(b["mass_initial"] for b in run.summary["bodies"] if b["name"] == "slider")
    power = np.diff(history["external"]) / np.diff(times)

    def middle(values):
        return 0.5 * (values[1:] + values[:-1])

    drawing = power + LOAD * middle(history["slider_velocity_z"]) + 2 * DAMPING * middle(history["kinetic"])
    return middle(times), drawing / SPEED - DAMPING * mass * SPEED


def height(run):
    history = run.history
    return history["time"], sum(history[f"top_{i}_position_z"] for i in range(4)) / 4


def measure(run, refine, variant):
    times, force = forces(run)
    force = force[times > REST] / LOAD
    times, top = height(run)
    return {"bumps": float(np.ptp(top[times >= REST]) / (SIZE / refine)), "ripple": float(np.sqrt(np.mean(force**2))),
            "drag": float(abs(np.mean(force))), "energy": run.summary["energy"]["balance_error_max"]}


STUDY = Study(
    name="sliding_block",
    title="A block slides over a flat floor of another mesh, without friction",
    reference="exact: one height, no tangential force",
    quantities=(
        Quantity("ripple", "tangential force", "root of its mean square over the load"),
        Quantity("drag", "mean tangential force", "over the load: a friction that is not there"),
        Quantity("bumps", "height", "highest minus lowest, over the size of an element of the floor"),
        Quantity("energy", "energy balance", "largest error over the initial energy"),
    ),
    groups=("contact", "precision"),
    mesh="refinement",
    meshes={"full": [1, 2], "quick": [1]},
    report_mesh=1,
    fine={"full": 1},
    foremost=FINE,
    setup=setup,
    measure=measure,
    sweeps=(Sweep("Penalty factor", "contact.beta", {"full": [0.1, 0.3, 1.0, 3.0, 10.0], "quick": [1.0]},
                  (PLAIN_TITLE, "faces, penalty", "slideline, penalty"), 1),),
)


def friction_setup(refine, variant):
    plain = setup(refine, variant)
    return Setup(plain.scene, [*plain.settings, f"contact.friction={FRICTION}"], refine=refine)


def friction_measure(run, refine, variant):
    times, force = forces(run)
    force = force[times > REST] / LOAD
    return {"force": float(np.mean(np.abs(force - FRICTION)) / FRICTION), "mean": float(abs(np.mean(force) / FRICTION - 1)),
            "energy": run.summary["energy"]["balance_error_max"]}


WITH_FRICTION = Study(
    name="sliding_friction",
    title="The same with friction, coefficient 0.3",
    reference="Coulomb: the tangential force is 0.3 times the load",
    quantities=(
        Quantity("force", "force of friction", "mean |F / (0.3 load) - 1|"),
        Quantity("mean", "mean force of friction", "|mean F / (0.3 load) - 1|"),
        Quantity("energy", "energy balance", "largest error over the initial energy"),
    ),
    groups=("contact", "precision"),
    mesh="refinement",
    meshes={"full": [1, 2], "quick": [1]},
    fine={"full": 1},
    foremost=FINE,
    report_mesh=1,
    setup=friction_setup,
    measure=friction_measure,
)
