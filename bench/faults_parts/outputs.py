"""Whether a fault changes what a run leaves: all that a user could see of it."""

import glob
import os
import re
import shutil
import subprocess
import time

from report_parts.builds import ROOT
from state_hashes_parts import fingerprint
from state_hashes_parts.cases import all_cases

from .quick_tests import MOST

DECKS = "data/decks"
LIMIT = 300  # seconds
TIMES = re.compile(r'"(?:started|wall_seconds|element_steps_per_second|[a-z_]*seconds|version|threads)":[^,}\]]*|\d[\d.e+-]* ?(?:s|ms|us|GB|MB|kB)\b')


class Run:
    """A run of the program that shows what faults change."""

    def __init__(self, name, arguments):
        self.name, self.arguments = name, arguments
        self.seen, self.seconds, self.left = frozenset(), 0.0, None

    def result(self, program, tree, folder, environment, limit):
        """What it leaves: summary, history, fields, page, and, of decks, the scene that they become."""
        shutil.rmtree(folder, ignore_errors=True)
        try:
            done = subprocess.run([program, "run", *self.arguments, "--quiet", "--threads", "1", "--out", folder], cwd=tree,
                                  capture_output=True, text=True, errors="replace", timeout=limit,
                                  env={**os.environ, **environment}, check=False)
            found = fingerprint.of_run(done.returncode, done.stderr, folder)
            page = os.path.join(folder, "index.html")
            if os.path.exists(page):
                with open(page, encoding="utf-8", errors="replace") as file:
                    found["page"] = fingerprint.checksum(TIMES.sub("", file.read()).replace(folder, "").encode())
        except subprocess.TimeoutExpired:
            found = {"status": "does not end"}
        except (OSError, ValueError, KeyError) as error:
            found = {"status": f"cannot be read: {error}"}
        return found


def all_runs():
    runs = [Run(case.name, case.arguments()) for case in all_cases(True)]
    for kind in ("*.k", "abaqus/*.inp", "radioss/*_0000.rad"):
        for path in sorted(glob.glob(os.path.join(ROOT, DECKS, kind))):
            runs.append(Run(os.path.basename(path), [os.path.relpath(path, ROOT), "--lenient", "--set", "time.steps=200"]))
    return runs


def traced(runs, program, tree, scratch):
    """What each leaves without a fault, twice: of the rest nothing can be said."""
    path = os.path.join(scratch, "seen")
    kept = []
    for run in runs:
        with open(path, "wb") as file:
            file.write(bytes(MOST))
        start = time.monotonic()
        run.left = run.result(program, tree, os.path.join(scratch, "out"), {"PINBALL_FAULTS_SEEN": path}, LIMIT)
        run.seconds = time.monotonic() - start
        with open(path, "rb") as file:
            run.seen = frozenset(n for n, byte in enumerate(file.read()) if byte)
        again = run.result(program, tree, os.path.join(scratch, "out"), {}, LIMIT)
        if not fingerprint.differences(run.left, again):
            kept.append(run)
        elif "page" in run.left and not fingerprint.differences({k: v for k, v in run.left.items() if k != "page"}, again):
            run.left.pop("page")
            kept.append(run)
    return kept


def changed_by(number, runs, program, tree, scratch, budget):
    """(name of the first run that leaves something else, the places where it does); (None, ...): none was seen to."""
    used = 0.0
    for run in sorted((r for r in runs if number in r.seen), key=lambda r: r.seconds):
        if used > budget:
            return None, []
        start = time.monotonic()
        found = run.result(program, tree, os.path.join(scratch, "out"), {"PINBALL_FAULT": str(number)}, 20 + 10 * run.seconds)
        used += time.monotonic() - start
        places = [place for place, _, _ in fingerprint.differences(run.left, found)]
        if places:
            return run.name, places
    return None, []
