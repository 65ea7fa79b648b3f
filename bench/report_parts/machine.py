"""The machine, the compiler and the state of the tree."""

import os
import subprocess

from .builds import NATIVE, PRESETS, ROOT, compiler_of, flags


def output_of(command):
    """stdout; "" of a program that is not there."""
    try:
        return subprocess.run(command, capture_output=True, text=True, cwd=ROOT, env={**os.environ, "LC_ALL": "C"}).stdout
    except OSError:
        return ""


def first_line(command):
    lines = output_of(command).splitlines()
    return lines[0].strip() if lines else "unknown"


def lscpu():
    lines = output_of(["lscpu"]).splitlines()
    return {key.strip(): value.strip() for key, _, value in (line.partition(":") for line in lines)}


def memory_gib():
    pages = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE")
    return pages / 2**30


def vector_sets(listed):
    return [name for name in ("sse2", "avx", "avx2", "fma", "avx512f", "avx512dq", "avx512vl", "asimd", "sve")
            if name in listed]


def has_avx2():
    """True also where the processor does not say what it has."""
    listed = lscpu().get("Flags", "avx2").split()
    return "avx2" in listed


def describe(presets=PRESETS):
    cpu = lscpu()
    changed = output_of(["git", "status", "--porcelain", "--untracked-files=no"]) != ""
    return {
        "cpu": cpu.get("Model name", "unknown"),
        "cores": os.cpu_count(),
        "caches": {name: cpu[name + " cache"] for name in ("L1d", "L1i", "L2", "L3") if name + " cache" in cpu},
        "vector_sets": vector_sets(cpu.get("Flags", "").split()),
        "memory_gib": round(memory_gib(), 1),
        "virtual": cpu.get("Hypervisor vendor"),
        "load_average": round(os.getloadavg()[0], 2),
        "compiler": first_line([compiler_of(NATIVE), "--version"]),
        "revision": first_line(["git", "rev-parse", "--short=12", "HEAD"]) + (" with local changes" if changed else ""),
        "flags": {preset: flags(preset) for preset in presets},
    }
