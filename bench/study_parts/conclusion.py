"""The conclusions, made from the numbers: sentences in HTML, with each number where it comes from."""

from report_parts.page_parts import escape

from .variants import PLAIN_TITLE


def at_report_mesh(part, key):
    """([(error, curve, point)] of all methods at the report's mesh, (curve, point) of the plain one or None)."""
    found, plain = [], None
    for c, curve in enumerate(part["curves"]):
        for p, point in enumerate(curve["points"]):
            if point["mesh"] == part["report_mesh"] and point["failure"] is None:
                found.append((point["errors"][key], c, p))
                plain = (c, p) if curve["method"] == PLAIN_TITLE else plain
    return found, plain


def errors(n):
    """For each study: who errs least at the report's resolution, and the frontier's ends."""
    lines = []
    for i, part in enumerate(n.value("studies")):
        if not part["curves"]:
            continue
        quantity = part["quantities"][0]
        found, plain = at_report_mesh(part, quantity["key"])
        if plain is None:
            continue
        (_, c, p), (pc, pp) = min(found), plain
        at = ("studies", i, "curves")
        text = (f"<b>{escape(part['title'])}</b>, {escape(quantity['title'])}, {n.show('studies', i, 'report_mesh')} "
                f"{escape(part['mesh'])}: plain {n.percent(*at, pc, 'points', pp, 'errors', quantity['key'])}")
        method = part["curves"][c]["method"]
        if method != PLAIN_TITLE:
            text += f", least with {escape(method)}: {n.percent(*at, c, 'points', p, 'errors', quantity['key'])}"
        for a, aim in enumerate(part["aims"]):
            cost = part["cheapest"][quantity["key"]][a]
            if cost:
                text += (f"; {100 * aim:g} % cheapest with {escape(cost['method'])}, {'at most ' if cost['at_most'] else ''}"
                         f"{n.show('studies', i, 'cheapest', quantity['key'], a, 'seconds')} s")
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


def energy(n):
    """The balance of each study that has contact: of the plain algorithm, and the worst."""
    lines = []
    for i, part in enumerate(n.value("studies")):
        if not part["curves"] or not any(q["key"] == "energy" for q in part["quantities"]):
            continue
        found, plain = at_report_mesh(part, "energy")
        if plain is None:
            continue
        (_, wc, wp), at = max(found), ("studies", i, "curves")
        lines.append(f"{escape(part['name'])} {n.percent(*at, plain[0], 'points', plain[1], 'errors', 'energy')} plain, "
                     f"at most {n.percent(*at, wc, 'points', wp, 'errors', 'energy')} ({escape(part['curves'][wc]['method'])})")
    return ["Error of the energy balance at the report's resolution: " + "; ".join(lines) + "."] if lines else []


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
    return [*errors(n), *candidates(n), *energy(n), *precision(n), *failures(n),
            *(["Not in this program: " + escape(", ".join(missing)) + "."] if missing else [])]
