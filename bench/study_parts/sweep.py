"""Runs all points of the studies. In every round each is run once, in another order; errors are those of the first
round, a time is the least of all rounds: whatever else the machine does can only add to it."""

import dataclasses

from report_parts import measuring

from . import analysis, runs, variants

AIMS = (0.05, 0.01, 0.005)
LONG = 2.0  # seconds: a longer run is not repeated, its time strays little


def meshes_of(study, form, variant):
    """Only the foremost variants have the finest meshes, where those take long."""
    largest = study.fine.get(form) if variant.title not in study.foremost else None
    return [m for m in study.meshes[form] if largest is None or m <= largest]


def with_value(study, sweep, value, variant):
    """(setup, variant) of one value of a parameter."""
    setup = study.setup(sweep.mesh, variant)
    own = sweep.settings(value) if sweep.settings else [f"{sweep.key}={value * sweep.scale}"]
    return dataclasses.replace(setup, settings=[*setup.settings, *own]), variant


def known(study, form):
    """(variants that the program knows, [{variant, said}] of the others)."""
    kept, refused = [], []
    for variant in variants.of(study):
        try:
            runs.check(study.setup(study.meshes[form][0], variant), variant)
            kept.append(variant)
        except runs.Refused as error:
            refused.append({"method": variant.title, "said": str(error)})
    return kept, refused


def empty_point(**place):
    return {**place, "seconds": None, "times": [], "steps": None, "elements": None, "errors": {}, "failure": None}


def plan(study, form):
    """The study's part of the results, without numbers, and [(point, setup, variant, mesh)] that are to be run."""
    kept, refused = known(study, form)
    part = {"name": study.name, "title": study.title, "scene": "", "reference": study.reference, "mesh": study.mesh,
            "note": study.note, "report_mesh": study.report_mesh, "absent": refused,
            "quantities": [dataclasses.asdict(q) for q in study.quantities], "curves": [], "sweeps": []}
    jobs = []
    for variant in kept:
        curve = {"method": variant.title, "group": variant.group, "settings": list(variant.settings), "step": variant.step,
                 "precision": variant.precision, "points": []}
        part["curves"].append(curve)
        for mesh in meshes_of(study, form, variant):
            point = empty_point(mesh=mesh)
            curve["points"].append(point)
            jobs.append((point, study.setup(mesh, variant), variant, mesh))
            part["scene"] = study.setup(mesh, variant).scene
    for sweep in study.sweeps:
        entry = {"title": sweep.title, "key": sweep.key, "mesh": sweep.mesh, "curves": []}
        part["sweeps"].append(entry)
        for variant in (v for v in kept if v.title in sweep.variants):
            curve = {"method": variant.title, "points": []}
            entry["curves"].append(curve)
            for value in sweep.values[form]:
                point = empty_point(value=value)
                curve["points"].append(point)
                jobs.append((point, *with_value(study, sweep, value, variant), sweep.mesh))
    return part, jobs


def run_point(study, point, setup, variant, mesh):
    """Errors that are not finite, and runs without what is measured, are failures of the method."""
    try:
        seconds, summary, errors = runs.run(setup, variant, lambda done: study.measure(done, mesh, variant))
        if not all(error == error and abs(error) < float("inf") for error in errors.values()):
            raise ValueError("the error is no finite number")
    except (runs.Broken, runs.Refused, ValueError) as error:
        point["failure"] = str(error)
        return
    point["times"].append(seconds)
    point["seconds"] = min(point["times"])
    if not point["errors"]:
        point.update(errors=errors, steps=summary["steps"], elements=summary["elements"])


def measure(studies, form, rounds, say):
    """The parts of the results, one per study; a study of which the program knows nothing has no curves."""
    parts, jobs = [], []
    for study in studies:
        part, own = plan(study, form)
        parts.append(part)
        jobs += [(study, job) for job in own]
    for number in range(rounds):
        left = [(study, job) for study, job in jobs
                if number == 0 or (job[0]["failure"] is None and job[0]["times"][0] < LONG)]
        say(f"round {number + 1} of {rounds}: {len(left)} runs")
        begun = None
        for study, job in measuring.in_turn(left, number) if left else []:
            if study is not begun and number == 0:
                say(study.title)
            begun = study
            run_point(study, *job)
    for part in parts:
        derive(part)
    return parts


def pairs(points, key):
    return [(p["seconds"], p["errors"].get(key)) for p in points if p["failure"] is None]


def derive(part):
    """What follows from the points, per quantity: orders, costs, the frontier, the cheapest setting."""
    keys = [q["key"] for q in part["quantities"]]
    for curve in part["curves"]:
        good = [p for p in curve["points"] if p["failure"] is None]
        curve["orders"] = {k: analysis.order([1 / p["mesh"] for p in good], [p["errors"][k] for p in good]) for k in keys}
        curve["costs"] = {k: [analysis.cost(pairs(good, k), aim) for aim in AIMS] for k in keys}
    part["aims"] = list(AIMS)
    part["frontier"], part["cheapest"] = {}, {}
    for key in keys:
        places = [(c, p) for c, curve in enumerate(part["curves"]) for p, point in enumerate(curve["points"])
                  if point["failure"] is None]
        flat = [(part["curves"][c]["points"][p]["seconds"], part["curves"][c]["points"][p]["errors"][key]) for c, p in places]
        part["frontier"][key] = [list(places[i]) for i in analysis.frontier(flat)]
        curves = {curve["method"]: pairs(curve["points"], key) for curve in part["curves"]}
        part["cheapest"][key] = [analysis.cheapest(curves, aim) for aim in AIMS]
