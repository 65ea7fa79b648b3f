"""Runs the program on a scene and reads what it leaves."""

import csv
import json
import os
import subprocess
import time
from dataclasses import dataclass, field

import numpy as np

from report_parts import builds

from . import scene as scenes


@dataclass
class Run:
    status: int | None  # exit status; negative: killed by that signal; None: did not end in time
    said: str = ""  # on stderr
    summary: dict = field(default_factory=dict)  # empty where there is none
    history: dict = field(default_factory=dict)  # columns of history.csv
    last_good: bool = False  # whether the file that the message names is there
    seconds: float = 0.0
    folder: str = ""

    @property
    def message(self):
        """The error, without the program's name."""
        lines = [line for line in self.said.splitlines() if line.startswith("pinball: error: ")]
        return lines[0].removeprefix("pinball: error: ") if lines else ""


def read_history(path):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    numbers = np.array([[float(text) for text in row] for row in rows[1:] if len(row) == len(rows[0])], dtype=float)
    return dict(zip(rows[0], numbers.reshape(-1, len(rows[0])).T))


def named_file(message, folder):
    """Whether a message names a file of the folder that is there."""
    return any(os.path.isfile(word) and os.path.dirname(os.path.abspath(word)).startswith(os.path.abspath(folder))
               for word in (piece.strip('.,;:"') for piece in message.split()))


def run(scene, folder, threads=1, timeout=120.0, arguments=()):
    """scene: tables of scenes.scene, or the path of a file."""
    path = scene if isinstance(scene, str) else scenes.write(scene, folder)
    out = os.path.join(folder, "out")
    command = [builds.program(builds.NATIVE), "run", path, "--quiet", "--threads", str(threads), "--out", out, *arguments]
    start = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=timeout,
                              env={**os.environ, "GOMP_SPINCOUNT": "1000"})
    except subprocess.TimeoutExpired:
        return Run(None, seconds=time.monotonic() - start, folder=folder)
    result = Run(done.returncode, done.stderr, seconds=time.monotonic() - start, folder=folder)
    summary, history = (os.path.join(out, name) for name in ("summary.json", "history.csv"))
    if os.path.exists(summary):
        with open(summary, encoding="utf-8") as file:
            result.summary = json.load(file)
    if os.path.exists(history):
        result.history = read_history(history)
    result.last_good = named_file(result.message, folder)
    return result
