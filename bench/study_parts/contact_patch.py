"""Contact patch test: two blocks whose flat meshes do not fit, under uniform pressure. Which contact passes it?"""

import numpy as np

from .reference import vector
from .study import Quantity, Setup, Study, Sweep
from .variants import PLAIN_TITLE

PRESSURE = 0.01  # over Young's modulus
END = 60.0  # of the scene: the blocks have met and are at rest


def setup(elements, variant):
    """elements: along a side of the lower block; the upper one has a quarter more."""
    upper = 5 * elements // 4
    gap = 0.25 / elements  # the balls of both blocks just do not overlap
    return Setup("contact_patch", [
        f"body.lower.mesh.elements={vector(elements, elements, elements // 2)}",
        f"body.upper.mesh.elements={vector(upper, upper, upper // 2 + upper % 2)}",
        f"body.upper.position={vector(0.0, 0.0, 0.5 + gap)}", f"load.0.plane.point={vector(0.0, 0.0, 1.0 + gap)}",
        f"load.0.force={vector(0.0, 0.0, -PRESSURE)}", f"time.cfl={variant.step}"])


def measure(run, elements, variant):
    *_, (_, mesh) = run.fields()
    stress = mesh.cell_data["stress"][:, 2]
    mean = float(np.mean(stress))
    pressure = [-float(s.split()[-1].rstrip("]")) for s in run.settings if s.startswith("load.0.force=")][-1]
    if abs(-mean / pressure - 1) > 0.5:
        raise ValueError(f"the blocks are not pressed together: mean stress {mean:.3g}")
    deviation = np.abs(stress / mean - 1)
    return {"worst": float(np.max(deviation)), "rms": float(np.sqrt(np.mean(deviation**2)))}


def pressed(pressure):
    """Settings of another pressure: a small one takes longer to close the gap."""
    end = END * max(1.0, PRESSURE / pressure)
    return [f"load.0.force={vector(0.0, 0.0, -pressure)}", f"time.end={end}", f"output.field_times=[{end}]"]


STUDY = Study(
    name="contact_patch",
    title="Contact patch test: two blocks of other meshes under uniform pressure",
    reference="the stress is the same everywhere",
    quantities=(
        Quantity("worst", "stress across the contact, worst element", "largest |stress / mean stress - 1|"),
        Quantity("rms", "stress across the contact, all elements", "root of the mean square of stress / mean stress - 1"),
    ),
    groups=("contact", "precision"),
    mesh="elements along a side of the lower block",
    meshes={"full": [4, 8, 12], "quick": [4]},
    report_mesh=4,
    fine={"full": 8},
    foremost=(PLAIN_TITLE, "faces, penalty", "faces, projection", "slideline, penalty", "slideline, projection"),
    setup=setup,
    measure=measure,
    sweeps=(
        Sweep("Pressure over Young's modulus", "load.0.force", {"full": [0.003, 0.01, 0.03, 0.1], "quick": [0.03]},
              (PLAIN_TITLE, "faces, penalty", "faces, projection", "faces, lagrange"), 4,
              settings=pressed),
        Sweep("Penalty factor", "contact.beta", {"full": [0.1, 1.0, 10.0, 100.0], "quick": [1.0]},
              (PLAIN_TITLE, "balls to the face, penalty", "faces, penalty", "slideline, penalty"), 4),
    ),
)
