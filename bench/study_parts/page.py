"""index.html from results.json: everything on the page is in there."""

from report_parts.page_parts import escape, frame, image, judgement, repeat_section, section
from report_parts.pointers import Numbers, listing, table, two_digits

from . import conclusion, figures


def conclusion_section(n):
    quick = ("<p>This is the quick form: small meshes, one round; the figures to quote are those of the full form.</p>"
             if n.value("form") == "quick" else "")
    return section("conclusion", "Conclusions", quick, listing(conclusion.lines(n)))


def machine_section(n):
    machine = n.value("machine")
    rows = [["processor", escape(machine["cpu"])], ["cores", n.show("machine", "cores")],
            ["memory", n.show("machine", "memory_gib") + " GiB"],
            ["load at the start", n.show("machine", "load_average") + " jobs"],
            ["compiler", escape(machine["compiler"])], ["git revision", escape(machine["revision"])],
            ["rounds", n.show("rounds")], ["duration of this study", n.count("seconds") + " s"]]
    return section("machine", "Machine and method", "<div class=text>", table(["", ""], rows), "</div>",
                   "<p>Every point is one run of one thread; error and time come from the same runs. A time is the least of "
                   "all rounds, without what writing output takes. A variant is one change of the plain algorithm: penalty "
                   "between balls with the scene's beta, hourglass stiffness 0.05, 0.9 of the stable step, double precision. A "
                   "cost is read between the points of a curve on logarithmic scales, holds for all its finer meshes, and is "
                   "never continued beyond the points: not reached is a dash, &le; means that the coarsest mesh is good "
                   "enough. An order is the slope of log error over log element size by least squares; its residual is in "
                   "decades.</p>")


def percent_or_dash(n, *keys):
    return n.percent(*keys) if n.value(*keys) is not None else "–"


def errors_table(n, i):
    """All variants and quantities at the report's mesh."""
    part = n.value("studies", i)
    rows = []
    for c, curve in enumerate(part["curves"]):
        for p, point in enumerate(curve["points"]):
            if point["mesh"] == part["report_mesh"] or len(curve["points"]) == 1:
                at = ("studies", i, "curves", c, "points", p)
                failed = point["failure"] is not None
                shown = ["failed" if failed else n.percent(*at, "errors", q["key"]) for q in part["quantities"]]
                rows.append([escape(curve["method"]), n.show(*at, "mesh"), *shown, n.show(*at, "steps"),
                             n.show(*at, "seconds")])
    return table(["variant", "mesh", *(escape(q["title"]) for q in part["quantities"]), "steps", "time [s]"], rows,
                 "Errors at the resolution of the report, or of the scene as it stands")


def cost_text(n, *keys):
    cost = n.value(*keys)
    return "–" if cost is None else ("&le; " if cost["at_most"] else "") + n.show(*keys, "seconds")


def costs_table(n, i, key):
    part = n.value("studies", i)
    rows = []
    for c, curve in enumerate(part["curves"]):
        at = ("studies", i, "curves", c)
        order = curve["orders"][key]
        rows.append([escape(curve["method"]), *[cost_text(n, *at, "costs", key, a) for a in range(len(part["aims"]))],
                     n.show(*at, "orders", key, "order", form=two_digits) if order else "–",
                     n.show(*at, "orders", key, "residual", form=two_digits) if order else "–"])
    cheapest = [escape(cost["method"]) if (cost := part["cheapest"][key][a]) else "–" for a in range(len(part["aims"]))]
    rows.append(["cheapest", *cheapest, "", ""])
    title = next(q["title"] for q in part["quantities"] if q["key"] == key)
    return table(["variant", *(f"{100 * aim:g} % [s]" for aim in part["aims"]), "order", "residual"], rows,
                 f"{escape(title)}: seconds for an error, and order of convergence")


def sweep_parts(n, i, s):
    part, sweep = n.value("studies", i), n.value("studies", i, "sweeps", s)
    if not any(p["failure"] is None for c in sweep["curves"] for p in c["points"]):
        return []
    keys = [q["key"] for q in part["quantities"]][:2]
    rows = []
    for c, curve in enumerate(sweep["curves"]):
        for key in keys:
            title = next(q["title"] for q in part["quantities"] if q["key"] == key)
            at = ("studies", i, "sweeps", s, "curves", c, "points")
            rows.append([f"{escape(curve['method'])}: {escape(title)}",
                         *[n.percent(*at, p, "errors", key) if point["failure"] is None else "failed"
                           for p, point in enumerate(curve["points"])]])
    head = [n.show("studies", i, "sweeps", s, "curves", 0, "points", p, "value")
            for p in range(len(sweep["curves"][0]["points"]))]
    return [f"<h3>{escape(sweep['title'])}</h3>",
            image(figures.parameters(part, sweep, keys), f"{sweep['title']}: {sweep['mesh']} {part['mesh']}"),
            table([f"<code>{escape(sweep['key'])}</code>", *head], rows)]


def study_section(n, i):
    part = n.value("studies", i)
    keys = [q["key"] for q in part["quantities"]]
    norms = listing(f"{escape(q['title'])}: {escape(q['norm'])}" for q in part["quantities"])
    content = [f"<p>Reference: {escape(part['reference'])}. Mesh: {escape(part['mesh'])}. {escape(part['note'])}</p>", norms]
    if not part["curves"]:
        content.append("<p>Not in this program: " + escape(part["absent"][0]["said"]) + "</p>")
    else:
        content += [image(figures.work_precision(part, keys[:2]), f"{part['title']}: error over run time"), errors_table(n, i)]
        content += [costs_table(n, i, key) for key in keys[:2]]
        content += [piece for s in range(len(part["sweeps"])) for piece in sweep_parts(n, i, s)]
    return section(part["name"], escape(part["title"]), *content)


def candidates_section(n):
    pieces = []
    for e, entry in enumerate(n.value("candidates")):
        rows = []
        for r, row in enumerate(entry["rows"]):
            at = ("candidates", e, "rows", r)
            rows.append([escape(row["method"]), n.percent(*at, "error", "own"), n.show(*at, "gain"), n.show(*at, "time"),
                         n.show(*at, "faster"), judgement(row["met"])])
        caption = (f"{escape(entry['title'])}, {escape(entry['what'])}, mesh {n.show('candidates', e, 'mesh')}: plain "
                   + n.percent("candidates", e, "rows", 0, "error", "plain"))
        pieces.append(table(["variant", "error", "plain error / error", "time / plain time",
                             "times faster at the plain error", ""], rows, caption))
    return section("candidates", "Candidates for the defaults, beside the plain algorithm at the report's resolution",
                   "<p>Reached: at most half the error for at most 1.2 times the run time, or the same error at least 4 times "
                   "faster. Times of a run of milliseconds say little.</p>", *(pieces or ["<p>Nothing was measured.</p>"]))


def precision_section(n):
    rows = []
    for r, row in enumerate(n.value("precision")):
        at = ("precision", r)
        rows.append([escape(row["title"]), escape(row["what"]), n.show(*at, "mesh"), n.percent(*at, "double"),
                     n.percent(*at, "float"), n.show(*at, "time"), n.count(*at, "failures")])
    return section("precision", "Float in place of double precision",
                   "<p>The whole solver in float: of each scene the quantity and mesh whose error changes most, and the time "
                   "on the finest mesh.</p>",
                   table(["", "quantity", "mesh", "error, double", "error, float", "time / double", "failed"], rows))


def ensemble_section(n):
    ensemble = n.value("ensemble")
    rows = []
    for r, row in enumerate(ensemble["rows"]):
        at = ("ensemble", "rows", r)
        rows.append([escape(row["method"]), str(len(row["members"])), percent_or_dash(n, *at, "mean"),
                     percent_or_dash(n, *at, "deviation"), percent_or_dash(n, *at, "energy"), n.show(*at, "seconds"),
                     escape("; ".join(row["failures"]))])
    return section("rod_oblique", "The oblique rod: an ensemble",
                   "<p>The shot is little above the ballistic limit and round-off decides which elements erode: runs do not "
                   "converge one by one, and there is no error to give. What methods can be told apart by is the mean over "
                   "runs that differ in the length of the step alone. The report's single run left "
                   f"{n.percent('ensemble', 'reported')} of the rod.</p>",
                   image(figures.ensemble(ensemble), "Mass of the rod that is left, each run and the mean"),
                   table(["variant", "runs", "mass left, mean", "standard deviation", "largest energy error",
                          "time of a run [s]", "failed"], rows))


def render(results, files):
    """The page. files: {name: what it is} of those beside it."""
    n = Numbers(results)
    sections = [conclusion_section(n), *(study_section(n, i) for i in range(len(results["studies"]))),
                *([ensemble_section(n)] if results["ensemble"] else []), candidates_section(n), precision_section(n),
                machine_section(n), repeat_section("study", n.value("form"), files)]
    return frame("Pinball: run time against error", "Run time against error", sections)
