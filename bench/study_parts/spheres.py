"""An elastic sphere on a rigid wall, on a held floor of another mesh, and on its mirror image: one problem, three ways.

The curves of the reference begin at the touch. Balls touch before faces do, so that the courses are laid over each other
at the turn, where the sphere is at rest."""

import math

import numpy as np

from .reference import relative, table, vector, velocity_times
from .study import Quantity, Setup, Study, Sweep
from .variants import PLAIN_TITLE

RADIUS, SPEED = 5.0, 2.0
APPROACH, FORCE = 0.1378, 192.7  # largest, of the reference
REFERENCE = "axisymmetric finite strain, three meshes that agree to 0.1 %: data/reference/sphere_wall_converged.csv"
TURN = 0.101  # of the reference after the touch
WEDGE = 2 * math.pi / math.sin(math.radians(10))  # whole spheres in a wedge of ten degrees
QUANTITIES = (
    Quantity("force", "largest force", "|F / 192.7 - 1|, mean over a hundredth of the run"),
    Quantity("course", "velocity over time", "mean over the contact of |v - reference| / v0, laid over each other at the turn"),
    Quantity("approach", "largest approach of the centre of mass", "|d / 0.1378 - 1|, from the first force on"),
    Quantity("radius", "contact radius at the turn", "|a / reference - 1|"),
    Quantity("restitution", "velocity after impact", "|v / v0 - 0.9989|"),
    Quantity("energy", "energy balance", "largest error over the initial energy"),
)


def courses(history, body):
    """(times, velocity towards the other side, time of the turn) of the centre of mass."""
    velocity = -history[f"{body}_velocity_z"]
    times = velocity_times(history)
    after = int(np.argmax(velocity <= 0))
    if after == 0:
        raise ValueError("no turn")
    part = velocity[after - 1] / (velocity[after - 1] - velocity[after])
    return times, velocity, times[after - 1] + part * (times[after] - times[after - 1])


def compare(run, body, parts, end, radius):
    """Errors of one impact; radius: (time, contact radius) pairs."""
    reference = table("sphere_wall_converged.csv")
    times, velocity, turn = courses(run.history, body)
    reference_turn = float(np.interp(0.0, -reference["jau_v"], reference["t"]))
    fine = np.linspace(0.0, reference["t"][-1], 400)
    exact = smooth(reference["t"], reference["jau_v"], fine)
    course = np.mean(np.abs(np.interp(fine + turn - reference_turn, times, velocity) - exact)) / SPEED
    edges = np.linspace(0.0, end, 101)
    mass = parts * next(b["mass_initial"] for b in run.summary["bodies"] if b["name"] == body)
    force = mass * np.max(-np.diff(np.interp(edges, times, velocity)) / (end / 100))
    touched = max(0, int(np.argmax(np.abs(velocity / SPEED - 1) > 1e-5)) - 1)
    until = int(np.searchsorted(times, turn))
    steps, way = np.diff(times[touched:until]), velocity[touched:until]
    approach = np.sum(steps * (way[1:] + way[:-1]) / 2)
    time, measured = min(radius, key=lambda pair: abs(pair[0] - turn))
    expected = smooth(reference["t"], reference["jau_a"], np.array([time - turn + reference_turn]))[0]
    return {"force": relative(force, FORCE), "course": float(course), "approach": relative(approach, APPROACH),
            "radius": relative(measured, expected),
            "restitution": float(abs(-velocity[-1] / SPEED + reference["jau_v"][-1] / SPEED)),
            "energy": run.summary["energy"]["balance_error_max"]}


def smooth(x, y, at):
    """Cubic Hermite curve through the points: rows of the reference are 0.02 s apart."""
    slope = np.gradient(y, x)
    i = np.clip(np.searchsorted(x, at) - 1, 0, len(x) - 2)
    h = x[i + 1] - x[i]
    s = (at - x[i]) / h
    return ((1 + 2 * s) * (1 - s) ** 2 * y[i] + s * (1 - s) ** 2 * h * slope[i] + s**2 * (3 - 2 * s) * y[i + 1]
            + s**2 * (s - 1) * h * slope[i + 1])


def radius_of_forces(run):
    """(time, radius) of a circle with the pressure of Hertz that has the second moment of the contact forces, of those on
    the upper body, which point upwards."""
    pairs = []
    for time, mesh in run.fields():
        upwards = np.maximum(mesh.point_data["contact_force"][:, 2], 0.0)
        squared = np.sum(mesh.points[:, :2] ** 2, axis=1)
        total = np.sum(upwards)
        pairs.append((time, math.sqrt(2.5 * np.sum(upwards * squared) / total) if total > 0 else 0.0))
    return pairs


def radius_on_wall(run):
    """(time, radius): the middle between the last node on the wall and the next one on the meridian."""
    pairs, meridian = [], None
    for time, mesh in run.fields():
        if meridian is None:
            from_centre = np.linalg.norm(mesh.points - [0.0, 0.0, RADIUS], axis=1)
            on = np.abs(from_centre - RADIUS) < 1e-6 * RADIUS
            on &= (np.abs(mesh.points[:, 1]) < 1e-9) & (mesh.points[:, 2] < RADIUS)
            meridian = np.flatnonzero(on)[np.argsort(mesh.points[on, 0])]
            continue
        last = int(np.max(np.flatnonzero(mesh.points[meridian, 2] < 1e-9 * RADIUS), initial=0))
        pairs.append((time, float(np.mean(mesh.points[meridian[last:last + 2], 0]))))
    return pairs


def output(first, last, end):
    times = ", ".join(f"{t:.4f}" for t in np.arange(first, last + 1e-9, 0.005))
    return [f"output.field_times=[{times}]", 'output.fields=["contact_force"]', f"output.interval={end / 4000}"]


WALL_END, FLOOR_END, MIRROR_END = 0.22, 0.28, 0.24


def wall_setup(core, variant):
    along, ring = round(17 / 11 * core), round(8 / 11 * core)
    return Setup("sphere_wall", [f"body.sphere.mesh.core={vector(core, along)}", f"body.sphere.mesh.ring={ring}",
                                 f"time.cfl={variant.step}", *output(0.095, 0.105, WALL_END),
                                 "output.field_times=[0, 0.095, 0.1, 0.105]"])


def wall_measure(run, core, variant):
    return compare(run, "sphere", WEDGE, WALL_END, radius_on_wall(run))


def floor_setup(core, variant):
    across = round(core / 2)
    return Setup("sphere_floor", [f"body.sphere.mesh.core={core}", f"body.sphere.mesh.ring={core // 4}",
                                  f"body.floor.mesh.elements={vector(across, across, 1)}", f"time.cfl={variant.step}",
                                  *output(0.11, 0.155, FLOOR_END)])


def floor_measure(run, core, variant):
    return compare(run, "sphere", 4, FLOOR_END, radius_of_forces(run))


def mirror_setup(core, variant):
    settings = [f"time.cfl={variant.step}", *output(0.095, 0.13, MIRROR_END)]
    for body in ("upper", "lower"):
        settings += [f"body.{body}.mesh.core={core}", f"body.{body}.mesh.ring={core // 4}"]
    return Setup("sphere_sphere", settings)


def mirror_measure(run, core, variant):
    return compare(run, "upper", 2, MIRROR_END, radius_of_forces(run))


BETAS = {"full": [0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 100.0, 1000.0], "quick": [0.1, 10.0]}
BETA = (PLAIN_TITLE, "faces, penalty", "slideline, penalty")
FINE = (PLAIN_TITLE, "faces, lagrange", "faces, projection", "faces, penalty", "slideline, projection", "float")

WALL = Study(
    name="sphere_wall", title="Elastic sphere on a rigid wall: elements and steps", reference=REFERENCE, quantities=QUANTITIES,
    groups=("viscosity on", "hourglass", "step", "precision", "subcycling"),
    mesh="elements along the radius of the core (of a wedge)",
    meshes={"full": [5, 8, 11, 16], "quick": [4]}, report_mesh=11, setup=wall_setup, measure=wall_measure,
    fine={"full": 11}, foremost=(PLAIN_TITLE,), without=("a quarter of the time step",),
    note="The wall is not contact between meshes, but a plane for nodes. The contact radius is known to half an element.",
)
FLOOR = Study(
    name="sphere_floor", title="Elastic sphere on a held floor of another mesh", reference=REFERENCE, quantities=QUANTITIES,
    groups=("contact", "precision", "step"), mesh="elements across the core of the sphere",
    meshes={"full": [8, 12, 16, 24], "quick": [8]}, report_mesh=12, setup=floor_setup, measure=floor_measure,
    fine={"full": 16}, foremost=FINE, without=("a quarter of the time step",),
    sweeps=(Sweep("Penalty factor", "contact.beta", BETAS, BETA, 8),),
    note="The contact radius is that of the pressure of Hertz with the second moment of the contact forces.",
)
MIRROR = Study(
    name="sphere_sphere", title="Two equal elastic spheres collide, meshes that fit", reference=REFERENCE,
    quantities=QUANTITIES,
    groups=("contact", "precision"), mesh="elements across the core of a sphere",
    meshes={"full": [4, 8, 12], "quick": [4]}, report_mesh=12, setup=mirror_setup, measure=mirror_measure,
    sweeps=(Sweep("Penalty factor", "contact.beta", BETAS, BETA, 4),),
    note="The contact radius is that of the pressure of Hertz with the second moment of the contact forces.",
)
