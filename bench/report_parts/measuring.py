"""Times: programs of all builds take turns, and the order changes from round to round."""

import json
import os
import re
import statistics
import tempfile

from .builds import BASE, NATIVE, PRESETS, Failed, program, run

METHODS = ["slideline", "pinball"]
# The stages of figures 10 and 11, and the timers of the step that they are the sum of; the rest of the step is `other`.
STAGES = {
    "element update": ["internal_forces"],
    "contact: surface": ["pinballs"],
    "contact: search": ["contact_search"],
    "contact: forces": ["contact_forces"],
    "contact: scatter": ["contact_scatter"],
    "node update": ["integration"],
}
CONTACT = ["contact: surface", "contact: search", "contact: forces", "contact: scatter"]


def spread(values):
    lower, _, upper = statistics.quantiles(values, method="inclusive") if len(values) > 1 else 3 * values
    return {"median": statistics.median(values), "min": min(values), "max": max(values), "lower_quartile": lower,
            "upper_quartile": upper}


def in_turn(items, round_number):
    """The items, from another one on in every round, and backwards in every second cycle."""
    shift = round_number % len(items)
    turned = items[shift:] + items[:shift]
    return turned if (round_number // len(items)) % 2 == 0 else turned[::-1]


def compare(preset, scene, repeats, settings=(), refine=1):
    """What `pinball compare` of both methods says, one thread."""
    with tempfile.TemporaryDirectory() as where:
        out = os.path.join(where, "comparison.json")
        command = [program(preset), "compare", scene, "--vary", "contact.method=slideline,pinball", "--repeat",
                   str(repeats), "--threads", "1", "--refine", str(refine), "--quiet", "--json", out]
        for setting in settings:
            command += ["--set", setting]
        run(command)
        with open(out, encoding="utf-8") as file:
            return json.load(file)


def stage_seconds(repeat):
    """Seconds per stage of one run; `other` is what the timers of the stages leave of the whole."""
    phases = repeat["phase_seconds"]
    seconds = {stage: sum(phases[p] for p in timers) for stage, timers in STAGES.items()}
    seconds["other"] = max(0.0, repeat["wall_seconds"] - sum(seconds.values()))
    return seconds


def stages(scene, rounds, settings=(), refine=1):
    """Times per stage for both methods and all builds, from one series in which the builds take turns."""
    runs = {preset: [] for preset in PRESETS}
    for number in range(rounds):
        for preset in in_turn(PRESETS, number):
            runs[preset].append(compare(preset, scene, 1, settings, refine))
    result = {"scene": scene, "refine": refine, "settings": list(settings), "rounds": rounds, "builds": {}}
    for preset in PRESETS:
        methods = {}
        for index, method in enumerate(METHODS):
            variants = [one["variants"][index] for one in runs[preset]]
            assert all(v["settings"]["contact.method"] == method for v in variants)
            summary = variants[0]["summary"]
            seconds = [stage_seconds(r) for v in variants for r in v["repeats"]]
            total = [r["wall_seconds"] for v in variants for r in v["repeats"]]
            methods[method] = {
                "steps": summary["steps"], "elements": summary["elements"], "pinballs": summary["contact"]["pinballs"],
                "failure": variants[0]["failure"], "state_hash": summary["state_hash"],
                "stages": {stage: spread([s[stage] for s in seconds]) for stage in seconds[0]},
                "contact": spread([sum(s[c] for c in CONTACT) for s in seconds]),
                "contact_share": statistics.median(sum(s[c] for c in CONTACT) / t for s, t in zip(seconds, total)),
                "total": spread(total), "repeats": seconds,
            }
        result["builds"][preset] = {"simd_width": runs[preset][0]["machine"]["simd_width"]["double"], **methods}
    result["elements"] = summary["elements"]
    scalar, native = result["builds"][BASE], result["builds"][NATIVE]
    result["speed_up"] = {m: scalar[m]["total"]["median"] / native[m]["total"]["median"] for m in METHODS}
    result["precision"] = summary["precision"]
    result["threads"] = runs[PRESETS[0]][0]["machine"]["threads"]
    return result


def run_scene(preset, scene, threads, settings=(), refine=1):
    """The summary of `pinball run`."""
    with tempfile.TemporaryDirectory() as out:
        command = [program(preset), "run", scene, "--quiet", "--out", out, "--threads", str(threads), "--refine", str(refine)]
        for setting in settings:
            command += ["--set", setting]
        run(command)
        with open(os.path.join(out, "summary.json"), encoding="utf-8") as file:
            return json.load(file)


def benchmarks(preset, name, wanted, options=()):
    """What a benchmark program says (JSON) of those of its benchmarks whose names fit the pattern."""
    report = json.loads(run([program(preset, name), f"--benchmark_filter={wanted}", "--benchmark_format=json", *options]))
    for benchmark in report["benchmarks"]:
        if benchmark.get("error_occurred"):
            raise Failed(f"{name}: {benchmark['name']}: {benchmark['error_message']}")
    return report


def parts_of(name):
    """A benchmark's name without its arguments, in parts, and {argument: number}: they are separated by slashes."""
    parts = name.removesuffix("/real_time").split("/")
    arguments = [part for part in parts if re.fullmatch(r"\w+:\d+", part)]
    return [p for p in parts if p not in arguments], {key: int(n) for key, n in (a.split(":") for a in arguments)}


def kernel_times(rounds):
    """{preset: {ceilings, method: {counter: values over the rounds}}} of the larger scenes of bench_kernels."""
    result = {preset: {"triad": [], "peak": [], "pinball": {}, "slideline": {}} for preset in PRESETS}
    for number in range(rounds):
        for preset in in_turn(PRESETS, number):
            report = benchmarks(preset, "bench_kernels", "per_side:[0-9]{3}/threads:1/")
            ours = result[preset]
            ours["triad"].append(float(report["context"]["triad_GB_per_s_1_threads"]))
            ours["peak"].append(float(report["context"]["peak_GFLOP_per_s_1_threads"]))
            ours["simd_width"] = int(report["context"]["simd_width"])
            ours["caches"] = report["context"]["caches"]
            for benchmark in report["benchmarks"]:
                (_, method), _ = parts_of(benchmark["name"])
                for name, value in benchmark.items():
                    if isinstance(value, float):
                        ours[method].setdefault(name, []).append(value)
    return result
