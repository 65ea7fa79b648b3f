"""Reads history.csv; needs NumPy alone."""

import csv
import json
import os

import numpy as np

from view.fields import BadInput


def read_units(folder):
    """{quantity: unit} as summary.json names them; empty where there is none."""
    try:
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            return dict(json.load(file).get("unit_names", {}))
    except (OSError, ValueError):
        return {}


def read_history(path):
    """({column: (rows,) array}, {quantity: unit}). Raises BadInput."""
    try:
        with open(path, newline="", encoding="utf-8", errors="replace") as file:
            lines = file.read().split("\n")
    except OSError as error:
        raise BadInput(f"{path}: cannot be read: {error.strerror}")
    rows = list(csv.reader(line for line in lines if line and not line.startswith("#")))
    # The last row of a running or killed job may be cut.
    complete = [row for row in rows[1:] if len(row) == len(rows[0])]
    if not complete:
        raise BadInput(f"{path}: no rows yet")
    try:
        values = np.array(complete, dtype=float).reshape(-1, len(rows[0]))
    except ValueError as error:
        raise BadInput(f"{path}: not a history ({error})")
    columns = {name: values[:, i] for i, name in enumerate(rows[0])}
    missing = [name for name in ("time", "dt", "total", "balance_error", "momentum_x") if name not in columns]
    if missing:
        raise BadInput(f"{path}: not a history: no column {', '.join(missing)}")
    return columns, read_units(os.path.dirname(path))
