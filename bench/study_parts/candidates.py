"""At the report's own resolution: what each variant makes of the error and the run time of the plain algorithm.

The aim of an improvement: at most half the error for at most 1.2 times the run time, or the same error 4 times faster."""

from . import analysis
from .variants import PLAIN_TITLE

LESS_ERROR, MORE_TIME, FASTER = 2.0, 1.2, 4.0
# What the defaults of contact are chosen by: study, quantity.
JUDGED = (("two_bars", "faces"), ("contact_patch", "worst"), ("sphere_floor", "radius"), ("sphere_floor", "force"),
          ("sphere_sphere", "force"), ("sliding_block", "ripple"), ("sliding_block", "bumps"), ("newtons_cradle", "velocities"),
          ("cantilever", "deflection"), ("taylor_bar", "length_course"), ("plate_impact", "velocity"))


def at(curve, mesh):
    return next((p for p in curve["points"] if p["mesh"] == mesh and p["failure"] is None), None)


def compare(part, key, plain, curve):
    """One row, or None where one of the two has no such point."""
    before, after = (at(c, part["report_mesh"]) for c in (plain, curve))
    if before is None or after is None:
        return None
    error = {"plain": before["errors"][key], "own": after["errors"][key]}
    gain = error["plain"] / error["own"] if error["own"] > 0 else None
    time = after["seconds"] / before["seconds"]
    good = [(p["seconds"], p["errors"][key]) for p in curve["points"] if p["failure"] is None]
    same = analysis.cost(good, error["plain"])
    faster = before["seconds"] / same["seconds"] if same else None
    return {"method": curve["method"], "error": error, "gain": gain, "time": time, "faster": faster,
            "met": (gain is None or gain >= LESS_ERROR) and time <= MORE_TIME or (faster is not None and faster >= FASTER)}


def derive(parts):
    """[{study, quantity, mesh, rows}] of those studies that were measured at the report's resolution."""
    found = []
    for name, key in JUDGED:
        for part in parts:
            plain = next((c for c in part["curves"] if c["method"] == PLAIN_TITLE), None)
            if part["name"] != name or plain is None:
                continue
            rows = [compare(part, key, plain, c) for c in part["curves"] if c is not plain]
            rows = [row for row in rows if row is not None]
            if rows:
                quantity = next(q for q in part["quantities"] if q["key"] == key)
                found.append({"study": name, "title": part["title"], "quantity": key, "what": quantity["title"],
                              "mesh": part["report_mesh"], "rows": rows})
    return found
