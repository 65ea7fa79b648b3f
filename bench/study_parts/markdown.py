"""The tables of results.json as a page of Markdown, as bench/results keeps it."""

from .candidates import JUDGED, at


def percent(error):
    return "–" if error is None else f"{100 * error:.0f} %" if error >= 0.1 else f"{100 * error:.2g} %"


def seconds(value):
    return "–" if value is None else f"{value:.2g}"


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows])


def errors(results):
    """Errors of all variants at the report's resolution, one table per study."""
    pieces = []
    for part in results["studies"]:
        rows = [[c["method"], *(percent(p["errors"][q["key"]]) for q in part["quantities"]), seconds(p["seconds"])]
                for c in part["curves"] if (p := at(c, part["report_mesh"])) is not None]
        if rows:
            head = [f"{part['title']} ({part['report_mesh']} {part['mesh']})", *(q["title"] for q in part["quantities"]),
                    "time [s]"]
            pieces.append(table(head, rows))
    return pieces


def cheapest(results):
    rows = []
    for part in results["studies"]:
        for quantity in part["quantities"][:1] if part["curves"] else []:
            cells = []
            for cost in part["cheapest"].get(quantity["key"], []):
                cells.append("not reached" if cost is None
                             else f"{cost['method']}, {'at most ' if cost['at_most'] else ''}{seconds(cost['seconds'])} s")
            plain = next((c["orders"][quantity["key"]] for c in part["curves"] if c["method"] == "plain"), None)
            rows.append([f"{part['title']}: {quantity['title']}", *cells, f"{plain['order']:.2g}" if plain else "–"])
    aims = next((part["aims"] for part in results["studies"]), [])
    return table(["", *(f"cheapest for {100 * aim:g} %" for aim in aims), "order of plain"], rows) if rows else ""


def matrix(results):
    """Errors alone, which no busy machine changes: a row per variant, at the report's resolution."""
    parts = {part["name"]: part for part in results["studies"]}
    judged = [(parts[name], q) for name, key in JUDGED if name in parts and parts[name]["curves"]
              for q in parts[name]["quantities"] if q["key"] == key]
    methods = list(dict.fromkeys(c["method"] for part in results["studies"] for c in part["curves"]))
    rows = []
    for method in methods:
        cells = []
        for part, quantity in judged:
            curve = next((c for c in part["curves"] if c["method"] == method), None)
            point = at(curve, part["report_mesh"]) if curve else None
            cells.append(percent(point["errors"][quantity["key"]]) if point else "")
        if any(cells):
            rows.append([method, *cells])
    return table(["error", *(f"`{part['name']}`: {q['title']}" for part, q in judged)], rows) if rows else ""


def candidates(results):
    """One row per variant, one column per comparison with the plain algorithm: its error over the own one, and time."""
    entries = results.get("candidates", [])
    methods = list(dict.fromkeys(row["method"] for entry in entries for row in entry["rows"]))
    rows = []
    for method in methods:
        cells = []
        for entry in entries:
            row = next((r for r in entry["rows"] if r["method"] == method), None)
            gain = "" if row is None else "exact" if row["gain"] is None else f"{row['gain']:.3g}"
            cells.append(gain and f"{'**' if row['met'] else ''}{gain} ({row['time']:.2f}){'**' if row['met'] else ''}")
        rows.append([method, *cells])
    head = ["plain error / error (time / plain time)", *(f"{e['study']}: {e['what']}" for e in entries)]
    return table(head, rows) if rows else ""


def parameters(results):
    pieces = []
    for part in results["studies"]:
        for sweep in part["sweeps"]:
            if not sweep["curves"]:
                continue
            for quantity in part["quantities"][:1]:
                key = quantity["key"]
                rows = [[c["method"], *("failed" if p["failure"] else percent(p["errors"][key]) for p in c["points"])]
                        for c in sweep["curves"]]
                head = [f"{part['name']}, {quantity['title']}: {sweep['title']}",
                        *(f"{p['value']:g}" for p in sweep["curves"][0]["points"])]
                pieces.append(table(head, rows))
    return pieces


def ensemble(results):
    section = results["ensemble"]
    if not section:
        return ""
    rows = [[r["method"], len(r["members"]), percent(r["mean"]), percent(r["deviation"]), percent(r["energy"]),
             seconds(r["seconds"])] for r in section["rows"]]
    return table(["oblique rod", "runs", "mass left, mean", "standard deviation", "largest energy error", "time of a run [s]"],
                 rows)


def precision(results):
    rows = [[r["title"], r["what"], r["mesh"], percent(r["double"]), percent(r["float"]), f"{r['time']:.2f}"]
            for r in results["precision"]]
    head = ["", "quantity that changes most", "mesh", "error, double", "error, float", "time / double"]
    return table(head, rows) if rows else ""


def head(results):
    machine = results["machine"]
    return f"{results['form']} form, {results['rounds']} rounds, {results['seconds']:.0f} s; {machine['cpu']}; revision {machine['revision']}"


def render(results):
    sections = {
        "Errors at the resolution of the report, or of the scene as it stands": ("", [matrix(results)]),
        "What an error costs": ("Between the meshes of a setting, never beyond them. At most: the coarsest mesh is good enough.",
                                [cheapest(results)]),
        "Gain over the plain algorithm": (
            "Error of the plain algorithm over that of the change, in brackets the time of the change over that of the plain one. "
            "Bold:\nthe error is at most half for at most 1.2 times the time, or the same error is reached 4 times faster.",
            [candidates(results)]),
        "All errors of each study": ("", errors(results)),
        "Parameters": ("", parameters(results)),
        "Single precision": ("", [precision(results)]),
        "The oblique rod": ("", [ensemble(results)]),
    }
    pieces = ["# Run time against error", head(results)]
    for title, (text, tables) in sections.items():
        tables = [table for table in tables if table]
        if tables:
            pieces += [f"## {title}", *([text] if text else []), *tables]
    return "\n\n".join(pieces)
