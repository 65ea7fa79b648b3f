"""Curves of data/reference, and what several measurements have in common."""

import csv
import os

import numpy as np

from report_parts.builds import ROOT


def table(name):
    """{column: values} of a file of data/reference."""
    with open(os.path.join(ROOT, "data", "reference", name), newline="", encoding="utf-8") as file:
        head, *rows = csv.reader(line for line in file if not line.startswith("#"))
    return dict(zip(head, np.array(rows, dtype=float).T))


def relative(value, exact):
    return float(abs(value / exact - 1))


def probe(name, body, point, quantity, kind="node"):
    """A table of a scene file."""
    place = ", ".join(repr(float(x)) for x in point)
    return (f'[[probe]]\nname = "{name}"\nkind = "{kind}"\nbody = "{body}"\npoint = [{place}]\n'
            f'quantities = ["{quantity}"]\n\n')


def vector(*numbers):
    return "[" + ", ".join(repr(n) for n in numbers) + "]"


def velocity_times(history):
    """Times of the velocities in a history with a row per step: the middle of the step that begins at the time of a row;
    in the last row its time itself."""
    times = history["time"] + 0.5 * history["dt"]
    times[-1] = history["time"][-1]
    return times
