"""The conclusions, made from the numbers: sentences in HTML, with each number where it comes from."""

from report_parts.page_parts import escape

from .variants import PLAIN_TITLE


def place_of(results, name):
    return next((i for i, part in enumerate(results["studies"]) if part["name"] == name and part["curves"]), None)


def least(n, study, key):
    """(curve, point) of the least error at the report's mesh, and those of the plain algorithm; None if not measured."""
    part = n.value("studies", study)
    found, plain = [], None
    for c, curve in enumerate(part["curves"]):
        for p, point in enumerate(curve["points"]):
            if point["mesh"] == part["report_mesh"] and point["failure"] is None:
                found.append((point["errors"][key], c, p))
                plain = (c, p) if curve["method"] == PLAIN_TITLE else plain
    return (min(found)[1:], plain) if found and plain else None


def errors(n):
    """For each study: who errs least at the report's resolution, and the frontier's ends."""
    lines = []
    for i, part in enumerate(n.value("studies")):
        if not part["curves"]:
            continue
        quantity = part["quantities"][0]
        best = least(n, i, quantity["key"])
        if best is None:
            continue
        (c, p), (pc, pp) = best
        at = ("studies", i, "curves")
        text = (f"<b>{escape(part['title'])}</b>, {escape(quantity['title'])}, {n.show('studies', i, 'report_mesh')} "
                f"{escape(part['mesh'])}: plain {n.percent(*at, pc, 'points', pp, 'errors', quantity['key'])}")
        method = part["curves"][c]["method"]
        if method != PLAIN_TITLE:
            text += f", least with {escape(method)}: {n.percent(*at, c, 'points', p, 'errors', quantity['key'])}"
        for a, aim in enumerate(part["aims"]):
            cost = part["cheapest"][quantity["key"]][a]
            if cost:
                text += (f"; {100 * aim:g} % cheapest with {escape(cost['method'])}, "
                         f"{'at most ' if cost['at_most'] else ''}{n.show('studies', i, 'cheapest', quantity['key'], a, 'seconds')} s")
            else:
                text += f"; {100 * aim:g} % not reached"
        lines.append(text + ".")
    return lines


def candidates(n):
    """Which variants reach the aim of an improvement in most comparisons."""
    entries = n.value("candidates")
    counts = {}
    for e, entry in enumerate(entries):
        for row in entry["rows"]:
            met, of = counts.get(row["method"], (0, 0))
            counts[row["method"]] = (met + row["met"], of + 1)
    ranked = sorted((m for m in counts if counts[m][0]), key=lambda m: -counts[m][0] / counts[m][1])
    if not ranked:
        return []
    named = "; ".join(f"{escape(m)} in {counts[m][0]} of {counts[m][1]}" for m in ranked)
    return ["Half the error for at most 1.2 times the time of the plain algorithm, or the same error 4 times faster, at the "
            f"report's resolution: {named}."]


def precision(n):
    rows = n.value("precision")
    if not rows:
        return []
    worst = max(range(len(rows)), key=lambda i: rows[i]["change"])
    return [f"Float instead of double changes an error by {n.percent('precision', worst, 'change')} at most "
            f"({escape(rows[worst]['title'])}, {escape(rows[worst]['what'])}, {n.show('precision', worst, 'mesh')} elements)."]


def failures(n):
    lines = [f"{part['name']}, {curve['method']}, {point['mesh']}" for part in n.value("studies") for curve in part["curves"]
             for point in curve["points"] if point["failure"] is not None]
    return ["Runs that failed: " + escape("; ".join(lines)) + "."] if lines else []


def absent(n):
    """{title of a variant: what the program said}, of those that no study could run."""
    said, present = {}, set()
    for part in n.value("studies"):
        present |= {curve["method"] for curve in part["curves"]}
        said |= {a["method"]: a["said"] for a in part["absent"]}
    return {title: text for title, text in said.items() if title not in present}


def lines(n):
    missing = [*absent(n), *(part["title"] for part in n.value("studies") if not part["curves"])]
    return [*errors(n), *candidates(n), *precision(n), *failures(n),
            *(["Not in this program: " + escape(", ".join(missing)) + "."] if missing else [])]
