"""Plate impact: elastic and plastic waves, as solver/verification/waves.cpp compares them."""

import numpy as np

from .reference import probe, table, vector, velocity_times
from .study import Quantity, Setup, Study

STATIONS = ("0.0001", "0.25", "0.5", "0.75", "0.9999")  # X in the columns of the reference
SPEED = 1000.0  # of the impact [in/s]
OWN_PROBES = """[[probe]]
name = "face"
point = [0.0, 0.0, 1.0]

[[probe]]
name = "middle"
kind = "element"
point = [0.0, 0.0, 0.5]
"""


def setup(elements, variant):
    h = 1.0 / elements
    probes = ""
    for i, station in enumerate(STATIONS):
        layer = int(float(station) * elements)
        for end in (0, 1):
            probes += probe(f"s{i}_{end}", "plate", (0.0, 0.0, (layer + end) * h), "velocity")
    settings = [f"body.plate.mesh.size={vector(h, h, 1.0)}", f"body.plate.mesh.elements={vector(1, 1, elements)}",
                "output.interval=step", f"time.cfl={variant.step}"]
    return Setup("plate_impact", settings, more=probes, replace=((OWN_PROBES, ""),))


def measure(run, elements, variant):
    history, reference = run.history, table("plate_impact_copper_exact.csv")
    times = velocity_times(history)
    at = reference["t"][1:]
    at = at[at <= 10.66e-6]
    errors = []
    for i, station in enumerate(STATIONS):
        part = float(station) * elements % 1
        velocity = (1 - part) * history[f"s{i}_0_velocity_z"] + part * history[f"s{i}_1_velocity_z"]
        errors.append(np.abs(np.interp(at, times, velocity) - reference[f"v_X{station}"][1:len(at) + 1]) / SPEED)
    return {"velocity": float(np.mean(errors))}


STUDY = Study(
    name="plate_impact",
    title="Copper plate strikes a rigid wall: elastic and plastic wave",
    reference="exact by front tracking: data/reference/plate_impact_copper_exact.csv",
    quantities=(Quantity("velocity", "velocity at five stations", "mean over stations and times of |v - exact| / v0"),),
    groups=("viscosity off", "step", "precision"),
    mesh="elements over the thickness",
    meshes={"full": [25, 50, 100, 200, 400, 800], "quick": [25, 50, 100]},
    report_mesh=100,
    setup=setup,
    measure=measure,
    note="The reference is exact for small strains; the strain of 0.5 % changes the speed of waves by as much, which ends the "
         "convergence of the finest meshes.",
)
