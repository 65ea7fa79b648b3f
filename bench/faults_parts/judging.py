"""What becomes of each fault, and the table of all."""

from . import outputs, quick_tests

NOTICED, UNNOTICED, NO_CHANGE, OUT_OF_REACH = "noticed", "not noticed", "changes nothing seen", "not come by"
UNFINISHED = "unfinished"


def verdict(number, fault, tests, runs, program, options, scratch):
    found = {"number": number, "fault": fault.name, "file": fault.file, "room": fault.room, "rule": fault.rule,
             "what": fault.described(), "by": None, "how": "", "seconds": 0.0}
    reached = any(number in test.seen for test in tests)
    whole = True
    if reached:
        found["by"], found["how"], found["seconds"], whole = quick_tests.caught_by(number, fault, tests, scratch, options.budget)
    if found["by"]:
        found["verdict"] = NOTICED
        return found
    name, places = outputs.changed_by(number, runs, program, options.tree, scratch, options.budget)
    if name:
        found.update(verdict=UNNOTICED if whole else UNFINISHED, by=name, how="changes " + ", ".join(places[:3]))
    else:
        found["verdict"] = NO_CHANGE if reached else OUT_OF_REACH
    return found


def share_of(verdicts):
    """Noticed ones of those that change something, and how many these are."""
    noticed = sum(v["verdict"] == NOTICED for v in verdicts)
    changing = noticed + sum(v["verdict"] in (UNNOTICED, UNFINISHED) for v in verdicts)
    return (noticed / changing if changing else 1.0), changing


def counts(verdicts, key):
    """A row for each room, or rule: how many of each verdict."""
    rows = []
    for name in sorted({v[key] for v in verdicts}):
        some = [v for v in verdicts if v[key] == name]
        share, changing = share_of(some)
        numbers = [sum(v["verdict"] == kind for v in some) for kind in (NOTICED, UNNOTICED, NO_CHANGE, OUT_OF_REACH)]
        rows.append(f"| {name} | {len(some)} | " + " | ".join(str(n) for n in numbers) + f" | {100 * share:.0f} % of {changing} |")
    return rows


def cell(text):
    return text.replace("|", "\\|")


def table(verdicts, planted, tests):
    """(text in Markdown, share of the faults that change something which are noticed)"""
    share, changing = share_of(verdicts)
    lines = ["# Faults that tests notice", "",
             f"{planted} faults planted, {len(verdicts)} of them looked at with {tests} quick tests: {changing} change what tests or "
             f"runs of the program see, and {100 * share:.1f} % of these are noticed.", ""]
    for key, head in (("room", "room"), ("rule", "written by")):
        lines += [f"| {head} | faults | noticed | not noticed | change nothing seen | not come by | noticed, of those that change something |",
                  "|---|---|---|---|---|---|---|", *counts(verdicts, key), ""]
    for kind, head in ((UNNOTICED, "Not noticed, although a run of the program leaves something else"),
                       (UNFINISHED, "The same, but not all tests that come by them were run"),
                       (NO_CHANGE, "Change nothing seen"), (OUT_OF_REACH, "No quick test comes by them")):
        some = [v for v in verdicts if v["verdict"] == kind]
        if some:
            lines += [f"## {head}", "", "| file | fault | seen in |", "|---|---|---|"]
            lines += [f"| `{v['file']}` | {cell(v['what'])} | {cell(' '.join(filter(None, (v['by'], v['how']))))} |" for v in some] + [""]
    return "\n".join(lines), share
