"""index.html from results.json: everything on the page is in there."""

from . import conclusion, figures, measuring
from .builds import BASE, NATIVE
from .page_parts import escape, frame, image, judgement, repeat_section, section
from .pointers import Numbers, listing, table, two_digits, whole


def middle_and_range(n, *keys, scale=1):
    parts = {name: n.show(*keys, name, scale=scale) for name in ("median", "min", "max")}
    return f"{parts['median']} ({parts['min']}–{parts['max']})"


def conclusion_section(n):
    quick = " This is the quick form: short runs, few repetitions; the figures to quote are those of the full form."
    return section("conclusion", "Conclusion",
                   f"<p class=lead>{conclusion.paragraph(n)}{quick if n.value('form') == 'quick' else ''}</p>")


def machine_section(n):
    machine = n.value("machine")
    caches = ", ".join(f"{name} {size}" for name, size in machine["caches"].items())
    columns = n.value("comparison", "columns")
    meshes = [f"{escape(c['scene'])}" + (f", refine {c['refine']}" if c["refine"] > 1 else "") + ": "
              + n.count("comparison", "columns", i, "elements") for i, c in enumerate(columns)]
    rows = [["processor", escape(machine["cpu"])],
            ["cores", n.show("machine", "cores") + (f", virtual ({escape(machine['virtual'])})" if machine["virtual"] else "")],
            ["vector sets", escape(" ".join(machine["vector_sets"]))], ["caches", escape(caches)],
            ["memory", n.show("machine", "memory_gib") + " GiB"],
            ["load at the start", n.show("machine", "load_average") + " jobs"],
            ["compiler", escape(machine["compiler"])], ["git revision", escape(machine["revision"])],
            ["precision, threads", f"{escape(columns[0]['precision'])}, {n.show('comparison', 'columns', 0, 'threads')} thread"],
            ["elements", "<br>".join(meshes)],
            ["duration of this report", n.count("seconds", "measuring") + " s, after "
             + n.count("seconds", "building") + " s of builds and second compilations"]]
    flags = [[f"build/{preset}: {source}", f"<code>{escape(text)}</code>"]
             for preset, sources in machine["flags"].items() for source, text in sources.items()]
    return section("machine", "Machine, compiler, flags", "<div class=text>", table(["", ""], rows),
                   table(["build: source", "flags that decide the code"], flags), "</div>")


def stages_table(n, i):
    series = n.value("stages", i)
    rows = []
    for preset, build in series["builds"].items():
        for method in measuring.METHODS:
            scale = 1e3 / build[method]["steps"]
            rows.append([f"{preset} ({build['simd_width']} lanes), {method}"]
                        + [middle_and_range(n, "stages", i, "builds", preset, method, "stages", stage, scale=scale)
                           for stage in build[method]["stages"]]
                        + [middle_and_range(n, "stages", i, "builds", preset, method, "total", scale=scale),
                           n.percent("stages", i, "builds", preset, method, "contact_share")])
    names = list(series["builds"][NATIVE]["pinball"]["stages"])
    return table(["build, algorithm", *names, "whole step", "contact"], rows,
                 f"{escape(series['scene'])}, refine {n.show('stages', i, 'refine')}, "
                 f"{n.count('stages', i, 'elements')} elements: ms of a step, median (range) of "
                 f"{n.show('stages', i, 'rounds')} rounds in which the builds take turns, one thread")


def stages_section(n):
    parts = ["<p>The report's Figures 10 (slideline) and 11 (pinball): the time of a step by stage with vectorization off "
             "and on. Off is a separate build with one lane per kernel call and the compiler's vectorizers off; other flags are "
             "the same.</p>"]
    for i, series in enumerate(n.value("stages")):
        parts.append(image(figures.stages(series), f"Figures 10 and 11 redrawn: {series['scene']}, "
                                                    f"{series['elements']:,} elements"))
        parts.append(stages_table(n, i))
    return section("stages", "Time per stage, vectorization off and on", *parts)


def kernels_table(n):
    rows, wider = [], []
    for i, kernel in enumerate(n.value("vectorization", "kernels")):
        at = ("vectorization", "kernels", i)
        judged = kernel["vectorized"]
        wider = [preset for preset in kernel["builds"] if preset != BASE]
        code = [n.count(*at, "builds", NATIVE, "code", name)
                for name in ("packed_zmm", "packed_ymm", "packed_xmm", "scalar")]
        rows.append([escape(kernel["title"]) + (" *" if kernel["contact"] else ""), judged["compiler"],
                     judged["machine_code"], " / ".join(code),
                     n.count(*at, "builds", NATIVE, "code", "gathers") + " / "
                     + n.count(*at, "builds", NATIVE, "code", "scatters"),
                     judged["speed"], *(n.show(*at, "builds", preset, "speed_up", form=two_digits) for preset in wider),
                     f"<b>{judged['verdict']}</b>", n.percent(*at, "builds", NATIVE, "lanes_used")])
    return table(["kernel (* contact of pinball)", "compiler", "machine code", "packed zmm / ymm / xmm / scalar",
                  "gathers / scatters", "speed-up says", *wider, "vectorized", "lanes used"], rows,
                 "Is it vectorized? Floating-point arithmetic instructions are those of build/release; speed-ups are over one "
                 "lane, one thread.")


def kernel_details(n, i):
    kernel = n.value("vectorization", "kernels", i)
    judged, native = kernel["vectorized"], kernel["builds"][NATIVE]
    at = ("vectorization", "kernels", i)
    three = "agree" if judged["agree"] else "differ"
    texts = [f"The three sources {three}" + (": " + escape("; ".join(judged["explanations"])) if judged["explanations"] else "")
             + (". <b>Not explained.</b>" if judged["unexplained"] else "."),
             f"{middle_and_range(n, *at, 'builds', NATIVE, 'ns_per_item')} ns per {escape(kernel['item'])}, "
             f"{middle_and_range(n, *at, 'builds', BASE, 'ns_per_item')} with one lane",
             f"operations: {escape(native['operations_from'])}",
             f"packed part of the arithmetic with one lane: {n.percent(*at, 'vectorized', 'packed_fraction_of_one_lane_build')}",
             "functions: " + ", ".join(f"<code>{escape(name)}</code>" for name in native["functions"])]
    for compiler in ("gcc", "clang"):
        if judged[compiler] is not None:
            remarks = "\n".join(judged[compiler]["remarks"]) or "no remark on a loop of this kernel"
            texts.append(f"{compiler}: {judged[compiler]['verdict']}<pre>{escape(remarks)}</pre>")
    return f"<details><summary>{escape(kernel['title'])}</summary>{listing(texts)}</details>"


def kernels_section(n):
    kernels = n.value("vectorization", "kernels")
    return section(
        "kernels", "Which kernels are vectorized",
        f"<p>Scene: two plates slide over each other, {n.count('vectorization', 'pinballs')} elements, each with a "
        f"pinball; {n.count('vectorization', 'listed')} pinballs have neighbours "
        f"({n.count('vectorization', 'listed_pairs')} listed, "
        f"{n.count('vectorization', 'pairs_in_contact')} pairs in contact), "
        f"{n.show('vectorization', 'rounds')} rounds in which the builds take turns; the slideline's kernels on the same scene with "
        f"fewer elements. Three sources: what the compiler says of the "
        "loops (gcc's remarks, and clang's as a second opinion: " + escape(n.value("vectorization", "clang"))
        + "); which instructions stand in the functions of the kernel; and how much faster they are than with one lane.</p>",
        image(figures.speed_ups(kernels, n.value("vectorization", "aims", "gain")), "Speed-up of each kernel over one lane"),
        kernels_table(n),
        "<h3>Explanations, remarks, functions</h3>", *[kernel_details(n, i) for i in range(len(kernels))])


def work_section(n):
    rows = []
    for i, kernel in enumerate(n.value("vectorization", "kernels")):
        at = ("vectorization", "kernels", i, "builds", NATIVE)
        rows.append([escape(kernel["title"]), escape(kernel["item"]), n.count(*at, "items"),
                     n.show(*at, "bytes_per_item"), n.show(*at, "operations_per_item"), n.show(*at, "gb_per_s"),
                     n.percent(*at, "of_bandwidth"), n.show(*at, "gflop_per_s"), n.percent(*at, "of_peak"),
                     n.percent(*at, "of_roof")])
    ceilings = [[f"{preset} ({one['simd_width']} lanes)",
                 middle_and_range(n, "vectorization", "ceilings", preset, "triad_gb_per_s"),
                 middle_and_range(n, "vectorization", "ceilings", preset, "peak_gflop_per_s")]
                for preset, one in n.value("vectorization", "ceilings").items()]
    return section(
        "work", "Bytes, operations and the ceilings of the machine",
        "<p>Bytes are what has to move at least when nothing stays in a cache; what does stay makes a kernel look faster than "
        "memory. Ceilings were measured in the same rounds: a triad over arrays far larger than the caches, and multiply-adds "
        "in registers.</p>",
        table(["build", "triad [GB/s]", "multiply-adds [GFLOP/s]"], ceilings),
        image(figures.roofline(n.value("vectorization")), "Operations a second over operations a byte: one lane (circles) and "
                                                          "full vectors (squares)"),
        table(["kernel", "item", "items", "bytes / item", "operations / item", "GB/s", "of the triad", "GFLOP/s", "of the peak",
               "of the roof"], rows, "build/release, one thread"))


def ratio_table(n):
    rows = []
    for i, column in enumerate(n.value("comparison", "columns")):
        at = ("comparison", "columns", i)
        limited = "to the end" if column["steps_limit"] is None else "first " + n.count(*at, "steps_limit") + " steps, resting tiles worked"
        report = "–"
        if column["report"]:
            report = (n.show(*at, "report", "slideline") + " / " + n.show(*at, "report", "pinball") + " = "
                      + n.show(*at, "report_ratio"))
        rows.append([escape(column["title"]) + f"<br><small>{escape(column['scene'])}, refine {n.show(*at, 'refine')}</small>",
                     n.count(*at, "elements"), limited,
                     *[middle_and_range(n, *at, "methods", m, "seconds", "total") for m in measuring.METHODS],
                     n.show(*at, "ratio", "total"), n.show(*at, "ratio_per_step", "total"), report,
                     *[middle_and_range(n, *at, "methods", m, "seconds", "contact") for m in measuring.METHODS],
                     n.show(*at, "ratio", "contact"), n.show(*at, "ratio_per_step", "contact"),
                     *[n.percent(*at, "methods", m, "share") for m in measuring.METHODS]])
    return table(["", "elements", "run", "slideline [s]", "pinball [s]", "ratio", "per step", "report (Cray X-MP/14) [s]",
                  "contact: slideline [s]", "pinball [s]", "ratio", "per step", "share: slideline", "pinball"], rows,
                 "Table 2 of the report, continued. build/release, one thread, median (range); both methods advance in turns")


def profile_table(n):
    rows = []
    for i, column in enumerate(n.value("comparison", "columns")):
        for method in measuring.METHODS:
            at = ("comparison", "columns", i, "methods", method)
            rows.append([f"{escape(column['title'])}, {method}"] + [n.percent(*at, "stages", s, "share")
                                                                    for s in column["methods"][method]["stages"]]
                        + [n.count(*at, "surface_elements"), n.count(*at, "searches")])
    names = list(n.value("comparison", "columns", 0, "methods", "pinball", "stages"))
    return table(["", *names, "surface elements", "searches"], rows, "Profile: share of each stage in the run")


def comparison_section(n):
    return section(
        "comparison", "Slideline and pinball: Table 2, continued",
        "<p>Both methods start from the same state and advance in turns, so that a slow minute of the machine meets both. The "
        f"report prints {n.show('comparison', 'report', 'example 2, mesh 1', 'printed')} s for pinball on mesh 1 of example 2, "
        "less than the rest of a step takes there; "
        f"{n.show('comparison', 'report', 'example 2, mesh 1', 'pinball')} s fits and is what its ratio "
        "is given for. The bodies go different ways with the two methods, which make different numbers of steps; ratios per step "
        "leave that out. Lists of both last over erosions: what lies behind elements that may soon erode is listed "
        "beforehand. Runs of a limited number of steps show the beginning of the penetration: contact has "
        "begun, erosion has not gone far.</p>",
        image(figures.totals(n.value("comparison")), "Time of both methods, and the ratios"), ratio_table(n), profile_table(n))


def aims_section(n):
    rows = []
    for aim, result in n.value("comparison", "aims").items():
        at = ("comparison", "aims", aim)
        worst = n.percent(*at, "worst") if aim == "share" else n.show(*at, "worst")
        rows.append([escape(result["text"]), worst, f"{n.show(*at, 'met_in')} of {n.show(*at, 'of')} columns",
                     judgement(result["met"])])
    gains = n.value("vectorization", "aims", "kernels")
    least = min(gains, key=gains.get)
    at = ("vectorization", "aims")
    rows.append([f"every contact kernel at least {n.show(*at, 'gain')} times as fast with vectors as with one lane, at least "
                 f"{n.count(*at, 'pinballs')} pinballs", n.show(*at, "kernels", least, form=two_digits),
                 f"{n.show(*at, 'met_by')} of {n.show(*at, 'of')} kernels", judgement(n.value(*at, "met"))])
    rows.append(["all contact stages of a step together, the same", n.show(*at, "together", form=two_digits), "",
                 judgement(n.value(*at, "together_met"))])
    missed = conclusion.missed_in_comparison(n) + conclusion.missed_by_kernels(n)
    return section("aims", "Aims", table(["aim", "worst", "reached in", ""], rows),
                   "<h3>Missed, and why</h3>" + listing(missed) if missed else "<p>Nothing was missed.</p>")


def differences_section(n):
    rows = []
    for i, column in enumerate(n.value("comparison", "columns")):
        for name in column["methods"]["pinball"]["results"]:
            at = ("comparison", "columns", i, "methods")
            form = whole if name == "steps" else "{:,.4g}".format
            rows.append([f"{escape(column['title'])}: {escape(name)}",
                         *[n.show(*at, method, "results", name, form=form) for method in measuring.METHODS]])
    smooth = [[method, n.show("sliding", "methods", method, "mean"), n.show("sliding", "methods", method, "bumps"),
               n.percent("sliding", "methods", method, "energy_error")]
              for method in measuring.METHODS]
    return section(
        "differences", "What differs in the results",
        "<h3>Smoothness of sliding</h3><p>A block is pressed on a held flat floor of another mesh and drawn over it. Balls make "
        "a bumpy floor: the height of the block follows them. Faces make a flat one.</p>",
        image(figures.sliding(n.value("sliding")), "Height of the sliding block"),
        table(["", "mean height over flat contact [elements]", "varies by [elements]", "energy error"], smooth),
        "<h3>Scenes</h3><p>At the end of each run, which for limited runs is early. Units of the scenes: "
        + ", ".join(f"{escape(c['scene'])} {escape(c['units'])}" for c in
                    {c["scene"]: c for c in n.value("comparison", "columns")}.values()) + ".</p>",
        table(["", "slideline", "pinball"], rows))


def render(results, files):
    """The page. files: {name: what it is} of those beside it."""
    n = Numbers(results)
    sections = [conclusion_section(n), machine_section(n), aims_section(n), comparison_section(n), stages_section(n),
                kernels_section(n), work_section(n), differences_section(n), repeat_section("report", n.value("form"), files)]
    return frame("Pinball: vectorization report", "Pinball and the slideline, with vectorization off and on", sections)
