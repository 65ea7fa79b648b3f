"""Section 2: is each kernel vectorized, and how near is it to what the machine gives?"""

import statistics

from . import builds, measuring, verdict
from .builds import BASE, NATIVE
from .kernels import KERNELS, ONE_ITEM_A_PASS

GAIN = 3.0  # aim: of each contact kernel of pinball over one lane
PINBALLS = 100_000  # aim: that have neighbours in the scene of that measurement
CONTACT_STAGES = ["pinballs", "contact_search", "contact_forces", "contact_scatter"]


def work_of(kernel, counters):
    """What the stage of a kernel has done in a step, or in a search: medians over the rounds."""
    def value(name, default=None):
        values = counters.get(f"{name}_{kernel.stage}")
        return statistics.median(values) if values else default

    items = value("items")
    pairs = statistics.median(counters["pairs_in_contact"])
    return {"items": items, "bytes": value("bytes"), "lanes": value("lanes"), "pairs_in_contact": pairs,
            "touching": min(items, 2 * pairs), "entries": statistics.median(counters["items_contact_forces"])}


def seconds_of(kernel, counters):
    """Of each round: seconds of the stage in a step, or in a search."""
    seconds = counters[f"seconds_{kernel.stage}"]
    if any(s <= 0 for s in seconds):
        raise builds.Failed(f"{kernel.title}: this stage did not run in the steps that were timed")
    return seconds


def operations_of(kernel, counts, width, work):
    """(floating-point operations per item, where the number comes from)."""
    if kernel.by_hand:
        return kernel.by_hand(work), "by hand: " + kernel.by_hand_text
    items = 1 if kernel.key in ONE_ITEM_A_PASS else width
    where = "node" if items == 1 else f"pack of {width}"
    return counts.operations / items, f"machine code: {counts.operations} in the function, one pass for a {where}"


def of_build(kernel, preset, times, code):
    """Times and ceilings of a kernel in one build."""
    counters = times[preset][kernel.method]
    work = work_of(kernel, counters)
    seconds = measuring.spread(seconds_of(kernel, counters))
    names, counts = code[preset][kernel.key]
    width = times[preset]["simd_width"]
    operations, origin = operations_of(kernel, code[NATIVE][kernel.key][1], times[NATIVE]["simd_width"], work)
    flops = operations * work["items"] / seconds["median"]
    bandwidth = work["bytes"] / seconds["median"]
    triad, peak = (statistics.median(times[preset][name]) * 1e9 for name in ("triad", "peak"))
    intensity = operations * work["items"] / work["bytes"]
    return {
        "simd_width": width,
        "seconds": seconds,
        "items": work["items"],
        "ns_per_item": {k: v / work["items"] * 1e9 for k, v in seconds.items()},
        "bytes_per_item": work["bytes"] / work["items"],
        "operations_per_item": operations,
        "operations_from": origin,
        "operations_per_byte": intensity,
        "gflop_per_s": flops * 1e-9,
        "gb_per_s": bandwidth * 1e-9,
        "of_bandwidth": bandwidth / triad,
        "of_peak": flops / peak,
        # What the roof allows at this intensity, and the part of it that is reached.
        "of_roof": flops / min(peak, intensity * triad) if flops > 0 else None,
        "lanes_used": work["lanes"] if width > 1 else None,
        "functions": names,
        "code": counts.as_dict(),
        "packed_fraction": counts.packed_fraction,
    }


def judge(kernel, per_build, inspected):
    """The three verdicts on the build for this machine, and what to make of them."""
    native, base = per_build[NATIVE], per_build[BASE]
    code, lines, gcc, clang = (inspected[name] for name in ("code", "lines", "gcc", "clang"))
    compiler_says = (gcc or clang)[kernel.key]
    _, counts = code[NATIVE][kernel.key]
    speed_up = base["seconds"]["median"] / native["seconds"]["median"]
    arithmetic = counts.packed_total + counts.scalar
    facts = {
        "packs": verdict.from_packs(lines[kernel.key]),
        "packed": counts.packed_fraction,
        "bandwidth": native["of_bandwidth"],
        "lanes": native["lanes_used"],
        "arithmetic": arithmetic / counts.instructions,
        "speed_up": speed_up,
    }
    three = (compiler_says.verdict, verdict.machine_verdict(counts), verdict.speed_verdict(speed_up))
    result, agree, reasons, unexplained = verdict.explain(*three, facts)
    # The scalar build is the control: nothing in it may be packed but copies.
    control = code[BASE][kernel.key][1].packed_fraction
    return {
        "compiler": three[0], "machine_code": three[1], "speed": three[2], "speed_up": speed_up,
        "verdict": result, "agree": agree, "explanations": reasons, "unexplained": unexplained, "facts": facts,
        "gcc": None if gcc is None else {"verdict": gcc[kernel.key].verdict, "remarks": gcc[kernel.key].texts()},
        "clang": None if clang is None else {"verdict": clang[kernel.key].verdict, "remarks": clang[kernel.key].texts()},
        # Source lines come from a second compilation: is it the same code?
        "same_code_with_lines": counts.instructions == lines[kernel.key].instructions,
        "packed_fraction_of_one_lane_build": control,
    }


def contact_together(times, preset):
    """Of each round: seconds of all contact stages in a step of pinball."""
    counters = times[preset]["pinball"]
    return [sum(values) for values in zip(*(counters[f"seconds_{stage}"] for stage in CONTACT_STAGES))]


def aims(kernels, times):
    """The gain of each contact kernel, and of the contact stages together, against the aim."""
    gains = {k["key"]: k["vectorized"]["speed_up"] for k in kernels if k["contact"]}
    base, native = (statistics.median(contact_together(times, preset)) for preset in (BASE, NATIVE))
    listed = int(statistics.median(times[NATIVE]["pinball"]["listed"]))
    return {"gain": GAIN, "kernels": gains, "met_by": sum(g >= GAIN for g in gains.values()), "of": len(gains),
            "together": base / native, "together_met": base / native >= GAIN, "pinballs": PINBALLS,
            "enough_pinballs": listed >= PINBALLS, "met": listed >= PINBALLS and min(gains.values()) >= GAIN}


def clang_remarks():
    """(remarks or None, which clang it is or why there are none)."""
    try:
        clang = builds.clang_remarks(NATIVE)
    except builds.Failed:
        return None, "clang++ could not compile the kernels with the flags of this build"
    if clang is None:
        return None, "clang++ is not installed"
    return clang, builds.run(["clang++", "--version"]).splitlines()[0]


def inspect(with_clang):
    """What compilers and object files say; with_clang: a second compiler's remarks."""
    code = {preset: builds.code_of_kernels(preset) for preset in builds.PRESETS}
    lines, gcc = builds.remarks_of_compiler(NATIVE)
    with_clang = with_clang or gcc is None
    clang, said = None, "left out of the quick form"
    if with_clang:
        clang, said = clang_remarks()
    if gcc is None and clang is None:
        raise builds.Failed(f"build/release was not made with gcc, and {said}: no compiler says what it vectorized")
    return {"code": code, "lines": lines, "gcc": gcc, "clang": clang, "clang_text": said}


def measure(rounds, inspected):
    code = inspected["code"]
    times = measuring.kernel_times(rounds)
    kernels = []
    for kernel in KERNELS:
        per_build = {preset: of_build(kernel, preset, times, code) for preset in builds.PRESETS}
        base = per_build[BASE]["seconds"]["median"]
        for one in per_build.values():
            one["speed_up"] = base / one["seconds"]["median"]
        kernels.append({"key": kernel.key, "title": kernel.title, "item": kernel.item, "method": kernel.method,
                        "contact": kernel.contact, "builds": per_build,
                        "vectorized": judge(kernel, per_build, inspected)})
    ceilings = {preset: {"triad_gb_per_s": measuring.spread(times[preset]["triad"]),
                         "peak_gflop_per_s": measuring.spread(times[preset]["peak"]),
                         "simd_width": times[preset]["simd_width"]} for preset in builds.PRESETS}
    middle = {name: int(statistics.median(times[NATIVE]["pinball"][name]))
              for name in ("surface_elements", "listed", "pairs_in_contact", "items_contact_forces", "searches")}
    return {"rounds": rounds, "pinballs": middle["surface_elements"], "listed": middle["listed"],
            "pairs_in_contact": middle["pairs_in_contact"], "listed_pairs": middle["items_contact_forces"],
            "searches": middle["searches"],
            "aims": aims(kernels, times), "ceilings": ceilings, "kernels": kernels, "clang": inspected["clang_text"]}
