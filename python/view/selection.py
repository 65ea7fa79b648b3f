"""Which times, bodies and parts of space are drawn."""

import math
import re
from dataclasses import dataclass

import numpy as np

from view.fields import BadInput
from view.quantity import shown


@dataclass
class Cut:
    """The half space that is kept: (x - origin) . normal >= 0."""

    normal: tuple
    origin: np.ndarray


def parse_cut(text):
    """The Cut of "x=0.5" or "x>0.5" (what is beyond is kept) or "x<0.5". Raises BadInput."""
    match = re.fullmatch(r"\s*([xyz])\s*([=<>])\s*(\S+)\s*", text)
    try:
        place = float(match[3]) if match else math.nan
    except ValueError:
        place = math.nan
    if not math.isfinite(place):
        raise BadInput(f'--cut: expected a plane such as x=0.5 (what lies at larger x is kept) or "x<0.5", got {text}')
    axis = "xyz".index(match[1])
    side = -1.0 if match[2] == "<" else 1.0
    return Cut(tuple(side if i == axis else 0.0 for i in range(3)),
               np.array([place if i == axis else 0.0 for i in range(3)]))


def choose_entries(entries, wanted, most):
    """Entries (time, path) to draw: nearest to the wanted times, or `most` of all, evenly spaced with both ends."""
    times = np.array([time for time, _ in entries])
    if wanted:
        chosen = {int(np.argmin(np.abs(times - t))) for t in wanted}
    else:
        chosen = set(np.linspace(0, len(entries) - 1, min(len(entries), most)).round().astype(int).tolist())
    return [entries[i] for i in sorted(chosen)]


def body_names(mesh):
    """Names of all bodies; of files without names their numbers."""
    count = int(mesh.cell_data["body"].max(initial=-1)) + 1 if "body" in mesh.cell_data else 1
    return list(mesh.names) or [str(i) for i in range(count)]


def chosen_bodies(names, only, hidden):
    """Numbers of the bodies to draw. Raises BadInput for a name that is none, or where none is left."""
    for option, wanted in (("--only", only), ("--hide", hidden)):
        for name in wanted or ():
            if name not in names:
                raise BadInput(f"{option}: no body {name}; there are: {', '.join(names)}")
    bodies = [i for i, name in enumerate(names) if (not only or name in only) and name not in (hidden or ())]
    if not bodies:
        raise BadInput("--hide: no body is left to draw")
    return bodies


def elements_of(mesh, bodies):
    """Indices of the elements to draw: not eroded, of these bodies."""
    mask = shown(mesh)
    if "body" in mesh.cell_data:
        mask &= np.isin(mesh.cell_data["body"], bodies)
    return np.flatnonzero(mask)


def mirror_scales(axes):
    """Factors (3,) of the whole and its images: [(1, 1, 1), (1, -1, 1)] for "y". Raises BadInput."""
    if not re.fullmatch(r"(?!.*(.).*\1)[xyz]{0,3}", axes):
        raise BadInput(f"--mirror: expected y for a body cut at y = 0, or x, z, xy ..., got {axes}")
    scales = [(1.0, 1.0, 1.0)]
    for axis in axes:
        i = "xyz".index(axis)
        scales += [tuple(-f if j == i else f for j, f in enumerate(scale)) for scale in scales]
    return scales
