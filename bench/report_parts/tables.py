"""The numbers of results.json as tables in files of their own."""

import csv
import os

from . import measuring

FILES = {
    "results.json": "everything",
    "stages.csv": "time per stage and build",
    "kernels.csv": "kernels: times, work, instructions, verdicts",
    "comparison.csv": "slideline and pinball on all meshes",
    "sliding.csv": "height of the sliding block over time",
}


def stages(results):
    rows = [["scene", "refine", "elements", "build", "simd_width", "method", "steps", "stage", "seconds_median", "seconds_min",
             "seconds_max"]]
    for series in results["stages"]:
        for preset, build in series["builds"].items():
            for method in measuring.METHODS:
                one = build[method]
                for stage, seconds in [*one["stages"].items(), ("contact", one["contact"]), ("total", one["total"])]:
                    rows.append([series["scene"], series["refine"], series["elements"], preset, build["simd_width"], method,
                                 one["steps"], stage, *(seconds[k] for k in ("median", "min", "max"))])
    return rows


def kernels(results):
    measured = ["items", "bytes_per_item", "operations_per_item", "gb_per_s", "gflop_per_s", "of_bandwidth", "of_peak", "of_roof",
                "lanes_used", "speed_up"]
    sources = ["compiler", "machine_code", "speed", "verdict"]
    rows = None
    for kernel in results["vectorization"]["kernels"]:
        for preset, one in kernel["builds"].items():
            if rows is None:
                rows = [["kernel", "build", "simd_width", "ns_per_item_median", "ns_per_item_min", "ns_per_item_max", *measured,
                         *one["code"], *(f"release_{s}" for s in sources)]]
            rows.append([kernel["key"], preset, one["simd_width"], *(one["ns_per_item"][k] for k in ("median", "min", "max")),
                         *(one[m] for m in measured), *one["code"].values(), *(kernel["vectorized"][s] for s in sources)])
    return rows


def comparison(results):
    rows = [["column", "scene", "refine", "elements", "steps_limit", "method", "seconds_total", "seconds_contact", "contact_share",
             "ratio_total", "ratio_contact", *results["comparison"]["columns"][0]["methods"]["pinball"]["results"]]]
    for column in results["comparison"]["columns"]:
        for method, one in column["methods"].items():
            rows.append([column["title"], column["scene"], column["refine"], column["elements"], column["steps_limit"], method,
                         one["seconds"]["total"]["median"], one["seconds"]["contact"]["median"], one["share"],
                         column["ratio"]["total"], column["ratio"]["contact"], *one["results"].values()])
    return rows


def sliding(results):
    rows = [["method", "time", "travel", "height"]]
    for method, one in results["sliding"]["methods"].items():
        rows += [[method, *values] for values in zip(one["time"], one["travel"], one["height"])]
    return rows


def write(results, folder):
    for name, rows in (("stages.csv", stages(results)), ("kernels.csv", kernels(results)),
                       ("comparison.csv", comparison(results)), ("sliding.csv", sliding(results))):
        with open(os.path.join(folder, name), "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows(rows)
