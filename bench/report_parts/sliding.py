"""A block pressed on a held flat floor of another mesh, drawn over it: how smooth is the surface that contact makes?"""

import json
import os

import numpy as np

from run_files import read_history

from .builds import NATIVE, program, run
from .measuring import METHODS

SIZE = 0.1  # of an element of the floor [m]
REST = 10.0e-3  # from here on the slider has settled [s]
TOP = 0.16  # height of the slider [m]
# The load gives the slider 14,000 m/s^2; to follow bumps of a tenth of an element at 10 m/s it needs 4,000.
SCENE = """title = "A block slides over a floor of another mesh"
units = "kg-m-s"
[time]
end = 40.0e-3
[element]
hourglass = "stiffness"
bulk_viscosity = false
[contact]
method = "pinball"
enforcement = "penalty"
[output]
interval = 1.0e-4
[damping]
mass = 500.0
[[material]]
name = "steel"
model = "elastic"
density = 7850.0
young_modulus = 2.1e11
poisson_ratio = 0.3
[[body]]
name = "floor"
material = "steel"
mesh = { type = "block", size = [1.6, 0.6, 0.1], elements = [16, 6, 1] }
position = [-0.3, -0.3, -0.1]
[[body]]
name = "slider"
material = "steel"
mesh = { type = "block", size = [0.24, 0.24, 0.16], elements = [3, 3, 2] }
position = [-0.12, -0.12, 0.022]
velocity = [10.0, 0.0, 0.0]
[[constraint]]
type = "fixed"
body = "floor"
directions = "all"
[[prescribed_velocity]]
body = "slider"
direction = [1.0, 0.0, 0.0]
speed = 10.0
[[load]]
body = "slider"
force = [0.0, 0.0, -1.0e6]
"""
CORNERS = [(-0.12, -0.12), (0.12, -0.12), (-0.12, 0.12), (0.12, 0.12)]


def probes():
    return "".join(f'[[probe]]\nname = "top_{i}"\nbody = "slider"\npoint = [{x}, {y}, {TOP + 0.022}]\n'
                   for i, (x, y) in enumerate(CORNERS))


def measure(where):
    """Height of the slider over flat contact, in elements of the floor, for both methods."""
    scene = os.path.join(where, "sliding.toml")
    with open(scene, "w", encoding="utf-8") as file:
        file.write(SCENE + probes())
    methods = {}
    for method in METHODS:
        out = os.path.join(where, "sliding_" + method)
        run([program(NATIVE), "run", scene, "--set", f"contact.method={method}", "--threads", "1", "--quiet", "--out", out])
        columns, _ = read_history(os.path.join(out, "history.csv"))
        height = sum(columns[f"top_{i}_position_z"] for i in range(4)) / 4
        place = sum(columns[f"top_{i}_position_x"] for i in range(4)) / 4
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
        later = columns["time"] >= REST
        methods[method] = {
            "time": columns["time"].tolist(),
            "travel": ((place - place[0]) / SIZE).tolist(),
            "height": ((height - TOP) / SIZE).tolist(),
            "mean": float(np.mean(height[later] - TOP) / SIZE),
            "bumps": float(np.ptp(height[later]) / SIZE),
            "energy_error": summary["energy"]["balance_error_max"],
        }
    return {"rest": REST, "element": SIZE, "methods": methods,
            "ratio": methods["pinball"]["bumps"] / methods["slideline"]["bumps"]}
