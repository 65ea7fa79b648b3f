"""Taylor's bar: large plastic flow. The foot is held on the plane, as in the calculations of the reference."""

import numpy as np

from report_parts.builds import Failed

from .reference import relative, table
from .study import Quantity, Setup, Study
from .variants import PLAIN_TITLE

RADIUS, LENGTH = 3.2, 32.4  # [mm]
FINAL_RADIUS, FINAL_LENGTH = 7.22, 21.42
WALL = '[[rigid_wall]]\nname = "wall"\nnormal = [0.0, 0.0, 1.0]\n'
HELD = '[[constraint]]\ntype = "fixed"\nplane = { normal = [0.0, 0.0, 1.0] }\ndirections = ["z"]\n'


def setup(core, variant):
    times = ", ".join(str(1e-3 * t) for t in (0, *table("taylor_bar_history.csv")["t_us"]))
    settings = [f"body.bar.mesh.core={core}", f"body.bar.mesh.ring={core // 2}", f"body.bar.mesh.layers={10 * core}",
                f"output.field_times=[{times}]", "output.field_interval=0", 'output.fields=["alive"]',
                f"time.cfl={variant.step}"]
    return Setup("taylor_bar", settings, replace=((WALL, HELD),))


def measure(run, core, variant):
    published = table("taylor_bar_history.csv")
    radius, length, times = [], [], []
    for time, mesh in run.fields():
        x, y, z = mesh.points.T
        if not times:
            edge = (z < 1e-6 * LENGTH) & (np.hypot(x, y) > (1 - 1e-6) * RADIUS)
            tail = int(np.argmax(z - 1e3 * np.hypot(x, y)))
        radius.append(float(np.mean(np.hypot(x, y)[edge])))
        length.append(float(z[tail]))
        times.append(1e3 * time)

    if len(times) != 1 + len(published["t_us"]):
        raise Failed(f"taylor_bar left {len(times)} fields, where the published times and the start are wanted")

    def worst(values, column):
        expected = np.interp(times[1:], published["t_us"], published[column])
        return float(np.max(np.abs(np.array(values[1:]) / expected - 1)))

    return {"radius": relative(radius[-1], FINAL_RADIUS), "length": relative(length[-1], FINAL_LENGTH),
            "radius_course": worst(radius, "radius_mm"), "length_course": worst(length, "length_mm")}


STUDY = Study(
    name="taylor_bar",
    title="Taylor bar: copper on a rigid wall, 227 m/s",
    reference="converged results of several programs, R = 7.22 and L = 21.42 mm after 80 us, both +-0.02; their history: "
              "data/reference/taylor_bar_history.csv",
    quantities=(
        Quantity("length_course", "length over time", "largest |L / published - 1|, 5 to 80 us"),
        Quantity("radius_course", "radius of the foot over time", "largest |R / published - 1|, 5 to 80 us"),
        Quantity("length", "final length", "|L / 21.42 mm - 1|"),
        Quantity("radius", "final radius", "|R / 7.22 mm - 1|"),
    ),
    groups=("viscosity on", "hourglass", "step", "precision", "subcycling"),
    mesh="elements across the core (of a full section)",
    meshes={"full": [4, 6, 8, 12], "quick": [4]},
    report_mesh=8,
    setup=setup,
    measure=measure,
    without=("a quarter of the time step",),
    fine={"full": 8},
    foremost=(PLAIN_TITLE, "float", "assumed strain"),
    note="The reference itself is given to 0.1 % (length) and 0.3 % (radius).",
)
