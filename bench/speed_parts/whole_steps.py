"""Whole steps of a block, and what the machine gives in the same run; LULESH in turn with it."""

import os
import re

from report_parts import measuring
from report_parts.builds import NATIVE, Failed, run

from .samples import Ratio

STEP, PART = "whole step", "whole step: part of the bandwidth"
CEILINGS = {"memory bandwidth (triad)": ("triad_GB_per_s", "GB/s"), "arithmetic peak": ("peak_GFLOP_per_s", "GFLOP/s")}
LULESH = "LULESH 2.0"
SMALLEST = 30
BESIDE_LULESH = 60  # elements along each side, for both


def read(report, log):
    """The results of bench_step (JSON)."""
    for benchmark in report["benchmarks"]:
        (name,), arguments = measuring.parts_of(benchmark["name"])
        precision = re.fullmatch("whole_steps<(.*)>", name).group(1)
        size, threads = arguments["per_side"]**3, arguments["threads"]
        log.add(STEP, size, precision, threads, benchmark["element_steps"] * 1e-6, "million element steps/s")
        log.add(PART, size, precision, threads, benchmark["of_bandwidth"], "-")
        if precision == "double":  # as the ceilings are
            for what, (key, unit) in CEILINGS.items():
                log.add(what, size, precision, threads, float(report["context"][f"{key}_{threads}_threads"]), unit)


def measure(per_side, log, options=()):
    read(measuring.benchmarks(NATIVE, "bench_step", f"/per_side:{per_side}/", options), log)


def lulesh_rate(text):
    """Million zone cycles per second from its figure of merit, which counts thousands although z/s stands behind it."""
    found = re.search(r"FOM\s*=\s*([0-9.eE+-]+)", text)
    if not found:
        raise Failed("LULESH did not print its figure of merit (FOM)")
    return float(found.group(1)) * 1e-3


def measure_lulesh(program, log):
    for threads in (1, 2):
        text = run([program, "-s", str(BESIDE_LULESH), "-i", "20"], env={**os.environ, "OMP_NUM_THREADS": str(threads)})
        log.add(LULESH, BESIDE_LULESH**3, "double", threads, lulesh_rate(text), "million zone cycles/s", built_for="its own")


def ratios(samples):
    return [
        Ratio("whole step: float over double", {"what": STEP, "precision": "float"}, {"what": STEP, "precision": "double"}),
        Ratio("whole step: two threads over one", {"what": STEP, "threads": 2}, {"what": STEP, "threads": 1}),
        Ratio(f"whole step: cost per element over that at {SMALLEST}^3", {"what": STEP}, {"what": STEP, "size": SMALLEST**3},
              inverse=True),
        Ratio("whole step over LULESH 2.0", {"what": STEP}, {"what": LULESH}),
    ]
