"""Scenes at random: whatever comes out, laws hold and the same run gives the same bits."""

import math
import os
from dataclasses import asdict

import numpy as np

from . import program
from .case import Row
from .judge import ACCURATE, STOPS, WARNS, WRONG, at_most, judge
from .scene import elastic, plastic, scene

COUNTS = {"full": 300, "quick": 20}
BODY_SIZE = 2.0  # a body fits into a ball of radius 1.73
DISTANCE = 1.8  # of its middle from the middle planes


def choose(random, *choices):
    return choices[random.integers(len(choices))]


def vector(random, size):
    return [float(x) for x in size * random.uniform(-1, 1, 3)]


def random_material(random, name):
    """Of one order of magnitude for all, so that penalty contact has a chance; ends of the range have their own rows."""
    common = {"density": 10**random.uniform(-0.5, 0.5), "young": 10**random.uniform(-0.5, 0.5), "poisson": random.uniform(0, 0.49)}
    if random.random() < 0.4:
        return elastic(name, **common)
    more = {"erosion_strain": 10**random.uniform(-1, 0)} if random.random() < 0.5 else {}
    return plastic(name, 10**random.uniform(-3, -1), 10**random.uniform(-3, -1), **more, **common)


def random_mesh(random):
    kind = choose(random, "block", "block", "sphere", "cylinder")
    if kind == "block":
        return {"type": kind, "size": [float(s) for s in random.uniform(1, BODY_SIZE, 3)],
                "elements": [int(n) for n in random.integers(1, 5, 3)]}
    if kind == "sphere":
        return {"type": kind, "radius": random.uniform(0.5, BODY_SIZE / 2), "core": int(random.integers(1, 4))}
    return {"type": kind, "radius": random.uniform(0.5, BODY_SIZE / 2), "length": random.uniform(1, BODY_SIZE),
            "core": int(random.integers(1, 4)), "layers": int(random.integers(1, 5))}


def random_contact(random):
    contact = {"method": choose(random, "pinball", "pinball", "slideline")}
    contact["enforcement"] = choose(random, "penalty", "penalty", "projection", "lagrange")
    if contact["enforcement"] == "penalty":
        contact |= {"beta": 10**random.uniform(-1, 0.3), "damping": random.uniform(0, 0.3)}
    elif contact["method"] == "pinball":
        contact["gap"] = choose(random, "pinball", "face")
    friction = contact["enforcement"] != "penalty" and contact.get("gap") != "pinball"  # others refuse it
    if friction and random.random() < 0.5:
        contact["friction"] = random.uniform(0.05, 0.6)
    if contact["method"] == "pinball":
        contact |= {"radius": choose(random, "initial", "current"), "radius_factor": random.uniform(0.8, 1.0)}
    return contact


def random_scene(seed):
    """Bodies around the z axis that fly towards the origin, with up to 0.2 of the wave speed."""
    random = np.random.default_rng([20240607, seed])
    bodies, materials = [], []
    count = int(random.integers(2, 5))
    for b, (x, y) in enumerate([(1, 1), (-1, 1), (-1, -1), (1, -1)][:count]):
        materials.append(random_material(random, f"m{b}"))
        place = np.array([x * DISTANCE, y * DISTANCE, random.uniform(-0.5, 0.5)])
        speed = 10**random.uniform(-2, -0.7)
        mesh = random_mesh(random)
        middle = np.array(mesh["size"]) / 2 if mesh["type"] == "block" else np.array([0, 0, mesh.get("length", 0) / 2])
        bodies.append({"name": f"b{b}", "material": f"m{b}", "mesh": mesh, "position": [float(p) for p in place - middle],
                       "velocity": [float(v) for v in speed * (-place / np.linalg.norm(place) + 0.2 * random.uniform(-1, 1, 3))],
                       "angular_velocity": vector(random, choose(random, 0, 0.1 * speed)), "axis": [*vector(random, 0.3)[:2], 1.0]})
    fastest = max(np.linalg.norm(body["velocity"]) for body in bodies)
    element = {"bulk_viscosity": bool(random.random() < 0.5), "hourglass": choose(random, "stiffness", "viscous", "assumed_strain", "assumed_strain")}
    made = scene(5 / fastest, materials, bodies, contact=random_contact(random), cfl=random.uniform(0.5, 0.9), steps=1500, element=element,
                 output={"interval": 5 / fastest / 50})
    return {**made, "precision": choose(random, "double", "double", "float")}


def one(seed, folder):
    """(verdict, largest energy balance error, whether three runs agree to the bit, seconds, most pairs in contact)"""
    made = random_scene(seed)
    runs = [program.run(made, os.path.join(folder, f"{seed}_{n}"), threads) for n, threads in enumerate((1, 1, 2))]
    verdict = judge(runs[0], made)
    results = [(run.status, run.summary.get("state_hash"), run.summary.get("steps")) for run in runs]
    error = runs[0].summary.get("energy", {}).get("balance_error_max")
    return verdict, math.nan if error is None else error, results[0] == results[1] == results[2], sum(run.seconds for run in runs), \
        runs[0].summary.get("contact", {}).get("pairs_max", 0)


def rows(count, folder, map_all=map):
    """Rows of the table for so many scenes. map_all: map, or that of a pool of threads."""
    results = list(map_all(lambda seed: one(seed, folder), range(count)))
    outcomes = {}
    for seed, (verdict, *_) in enumerate(results):
        outcomes.setdefault(verdict.outcome, []).append(seed)
    seconds = sum(result[3] for result in results)
    finished = sorted(error for verdict, error, *_ in results if verdict.outcome in (ACCURATE, WARNS) and math.isfinite(error))
    text = f"{count} scenes: " + ", ".join(f"{len(seeds)} {outcome}" for outcome, seeds in sorted(outcomes.items()))
    text += f"; contact in {sum(result[4] > 0 for result in results)}"
    if finished:
        text += "; energy balance error of those that ended: " + ", ".join(
            f"{name} {100 * finished[min(len(finished) - 1, int(part * len(finished)))]:.2g} %"
            for name, part in (("median", 0.5), ("90 %", 0.9), ("largest", 1.0)))
    bad = {seed: result[0] for seed, result in enumerate(results) if result[0].outcome not in (ACCURATE, WARNS, STOPS)}
    if bad:
        text += "; " + "; ".join(f"seed {seed} {verdict.outcome}: {verdict.text()}" for seed, verdict in list(bad.items())[:8])
    figures = [at_most("scenes that are wrong, crash or hang", len(bad), 0)]
    differ = [seed for seed, result in enumerate(results) if not result[2]]
    outcome = ACCURATE if not bad else WRONG
    same = at_most("scenes whose runs differ", len(differ), 0)
    return [Row("random scenes", "momentum, energy, finite state", outcome, not bad, text, [asdict(f) for f in figures], 0, seconds,
                (ACCURATE,)),
            Row("random scenes", "one thread twice and two threads: the same bits", WRONG if differ else ACCURATE, not differ,
                same.text() + (f": seeds {differ[:20]}" if differ else ""), [asdict(same)], 0, 0.0, (ACCURATE,))]
