"""The copy of the tree, built once. What does not compile is taken out: that is no fault that anybody could leave in."""

import os
import re
import shutil
import subprocess

from report_parts.builds import NATIVE, Failed, run

from .planting import plant

PLACE = re.compile(r"(?P<file>[^\s:'\"]+\.[ch]pp):(?P<line>\d+):")
TRIES = 12


def configure(tree, options):
    folder = os.path.join(tree, "build", NATIVE)
    if not os.path.exists(os.path.join(folder, "build.ninja")):
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        run(["cmake", "--preset", NATIVE, "-DPINBALL_BENCH=OFF", "-DPINBALL_PYTHON=OFF", *launcher, *options], cwd=tree)
    return folder


def lines_of(fault, text):
    first = text.count("\n", 0, fault.begin) + 1
    return range(first, first + fault.right.count("\n") + 1)


def blamed(said, tree, faults, texts):
    """Numbers of the faults in lines that stand in errors, or, where there are none, beside one."""
    near = {True: set(), False: set()}
    for line in said.splitlines():
        for found in PLACE.finditer(line):
            file = os.path.relpath(os.path.join(tree, "build", NATIVE, found["file"]), tree)
            for number, fault in faults.items():
                if fault.file == file and int(found["line"]) in lines_of(fault, texts[file]):
                    near["error:" in line].add(number)
    return near[True] or near[False]


def build(tree, faults, texts, options, targets, jobs, say):
    """The faults that compile, as {number: fault}; texts: {file: text} without faults."""
    faults = dict(faults)
    for _ in range(TRIES):
        plant(tree, faults)
        folder = configure(tree, options)
        done = subprocess.run(["ninja", "-C", folder, "-k", "0", "-j", str(jobs), *targets], capture_output=True, text=True,
                              errors="replace")
        if done.returncode == 0:
            return faults
        wrong = blamed(done.stdout + done.stderr, tree, faults, texts)
        if not wrong:
            raise Failed("the copy does not build, and no fault is to blame:\n" + "\n".join(done.stdout.splitlines()[-40:]))
        say(f"{len(wrong)} faults do not compile and are left out: " + ", ".join(sorted(faults[n].name for n in wrong)))
        for number in wrong:
            del faults[number]
    raise Failed(f"after {TRIES} tries the copy still does not build")
