"""index.html and table.md from results.json: everything in them is in there."""

import base64
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from report_parts.page_parts import escape, frame, image, section
from report_parts.pointers import table

from .judge import ACCURATE, CRASHES, HANGS, REFUSES, STOPS, UNCLEAR, WARNS, WRONG

MEANING = {
    ACCURATE: "ended; exact values and laws hold within the tolerance",
    WARNS: "ended, is not accurate, and the program said so",
    STOPS: "status 1: what, where and when, with the last good state",
    REFUSES: "status 2: an input that cannot be right, with file and what was expected",
    WRONG: "ended as if all were well, or stopped late",
    UNCLEAR: "stopped, but the message or the last good state is missing something",
    CRASHES: "killed by a signal, or another status",
    HANGS: "did not end",
}
COLOURS = {ACCURATE: "#1b7f4b", WARNS: "#e0a100", STOPS: "#3a6ea5", REFUSES: "#8a93a0", WRONG: "#b3261e", UNCLEAR: "#d1495b",
           CRASHES: "#7a0019", HANGS: "#4a0010"}


def groups(results):
    """{group: its rows}, in order."""
    found = {}
    for row in results["rows"]:
        found.setdefault(row["group"], []).append(row)
    return found


def counts_of(rows):
    found = {outcome: sum(row["outcome"] == outcome for row in rows) for outcome in MEANING}
    return {outcome: count for outcome, count in found.items() if count}


def chart(results):
    """Outcomes of each group, as a PNG in base64."""
    named = groups(results)
    figure, axes = plt.subplots(figsize=(9, 0.4 * len(named) + 1.2))
    left = dict.fromkeys(named, 0)
    for outcome in MEANING:
        widths = {group: counts_of(rows).get(outcome, 0) for group, rows in named.items()}
        if any(widths.values()):
            axes.barh(list(named), list(widths.values()), left=list(left.values()), color=COLOURS[outcome], label=outcome)
        left = {group: left[group] + widths[group] for group in named}
    axes.invert_yaxis()
    axes.set_xlabel("rows")
    axes.legend(ncol=4, frameon=False, loc="upper center", bbox_to_anchor=(0.4, -0.18 if len(named) > 4 else -0.4))
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=120, bbox_inches="tight")
    plt.close(figure)
    return base64.b64encode(buffer.getvalue()).decode()


def wrong(results):
    return [row for row in results["rows"] if not row["right"]]


def head(results):
    return (f"{len(results['rows'])} rows, {len(wrong(results))} wrong; {results['form']} form, {results['seconds']:.0f} s; "
            f"revision {results['machine']['revision']}")


def group_table(rows):
    cells = [[escape(row["title"]), f"<span class={'met' if row['right'] else 'missed'}>{escape(row['outcome'])}</span>",
              escape(row["text"]), f"{row['steps']:,}", f"{row['seconds']:.1f}"] for row in rows]
    return "<div class=text>" + table(["row", "outcome", "worst figure, or message", "steps", "s"], cells) + "</div>"


def render(results):
    legend = table(["outcome", "meaning", "rows"], [[escape(outcome), escape(text), str(counts_of(results["rows"]).get(outcome, 0))]
                                                    for outcome, text in MEANING.items()])
    bad = wrong(results)
    sections = [section("conclusion", "Outcome", f"<p class=lead>{escape(head(results))}</p>", "<div class=text>" + legend + "</div>",
                        image(chart(results), "Outcomes by group")),
                section("wrong", "Rows that are wrong", group_table(bad) if bad else "<p>None.</p>")]
    sections += [section(group.replace(" ", "-"), group.capitalize(), group_table(rows)) for group, rows in groups(results).items()]
    return frame("Pinball: stability under stress", "Stability under stress", sections)


def markdown(results):
    """The table of all rows, as bench/results keeps it."""
    lines = ["# Stability under stress", "", head(results), "", "| row | outcome | worst figure, or message |", "|---|---|---|"]
    for group, rows in groups(results).items():
        for row in rows:
            mark = row["outcome"] if row["right"] else f"**{row['outcome']}**"
            text = " ".join(row["text"].split()).replace("|", "\\|")
            lines.append(f"| {group}: {row['title']} | {mark} | {text} |")
    return "\n".join([*lines, ""])
