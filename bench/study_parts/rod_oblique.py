"""The oblique rod: an ensemble. Its end is decided by round-off, so that no single run converges to anything; what can be
compared is the mean over runs that differ in the length of the step alone, and how far they stray."""

import statistics

from . import runs
from .study import Setup, Variant
from .variants import PLAIN_TITLE, VARIANTS

REPORTED = 0.42  # mass of the rod that is left, of the report; its own result is a single run
GROUPS = ("plain", "contact")
FORMS = {"full": {"refine": 1, "steps": (0.90, 0.89, 0.88, 0.87, 0.86), "end": None},
         "quick": {"refine": 1, "steps": (0.90, 0.89), "end": 1e-5}}


def member(variant, refine, step, end):
    settings = [f"time.cfl={step}"] + ([f"time.end={end}"] if end else [])

    def measure(run):
        rod = run.summary["bodies"][0]
        return {"left": rod["mass_remaining"] / rod["mass_initial"], "energy": run.summary["energy"]["balance_error_max"]}

    return runs.run(Setup("rod_oblique", settings, refine=refine), variant, measure)


def measure(form, say):
    how, rows, absent = FORMS[form], [], []
    chosen = [v for v in VARIANTS if v.group in GROUPS] + [Variant("precision", "float", precision="float")]
    for variant in chosen:
        try:
            runs.check(Setup("rod_oblique", []), variant)
        except runs.Refused as error:
            absent.append({"method": variant.title, "said": str(error)})
            continue
        say(f"the oblique rod, {variant.title}")
        members, failures = [], []
        for step in how["steps"]:
            try:
                seconds, _, found = member(variant, how["refine"], step, how["end"])
                members.append({"step": step, "seconds": seconds, **found})
            except runs.Broken as error:
                failures.append(f"{step}: {error}")
        left = [m["left"] for m in members]
        rows.append({"method": variant.title, "members": members, "failures": failures,
                     "mean": statistics.fmean(left) if left else None,
                     "deviation": statistics.stdev(left) if len(left) > 1 else None,
                     "seconds": min((m["seconds"] for m in members), default=None),
                     "energy": max((m["energy"] for m in members), default=None)})
    return {"name": "rod_oblique", "refine": how["refine"], "end": how["end"], "reported": REPORTED, "rows": rows,
            "absent": absent, "plain": PLAIN_TITLE}
