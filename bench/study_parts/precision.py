"""What float costs in accuracy and saves in time: each point in float beside the same one in double precision."""

from .variants import PLAIN_TITLE

FLOAT = "float"


def derive(parts):
    """One row per study: the quantity and mesh whose error float changes most, and the run time of the finest mesh."""
    rows = []
    for part in parts:
        curves = {c["method"]: c for c in part["curves"]}
        if PLAIN_TITLE not in curves or FLOAT not in curves:
            continue
        floats = {p["mesh"]: p for p in curves[FLOAT]["points"] if p["failure"] is None}
        both = [(p, floats[p["mesh"]]) for p in curves[PLAIN_TITLE]["points"] if p["failure"] is None and p["mesh"] in floats]
        if not both:
            continue
        titles = {q["key"]: q["title"] for q in part["quantities"]}
        changes = [(abs(single["errors"][key] - double["errors"][key]), key, double, single)
                   for double, single in both for key in titles]
        change, key, double, single = max(changes, key=lambda c: c[0])
        last_double, last_float = both[-1]
        rows.append({"study": part["name"], "title": part["title"], "quantity": key, "what": titles[key],
                     "mesh": double["mesh"], "double": double["errors"][key], "float": single["errors"][key], "change": change,
                     "time": last_float["seconds"] / last_double["seconds"], "time_mesh": last_double["mesh"],
                     "failures": sum(p["failure"] is not None for p in curves[FLOAT]["points"])})
    return rows
