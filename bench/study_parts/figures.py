"""The figures of the page, as PNG in base64."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

from report_parts.figures import finish

from .variants import PLAIN_TITLE, VARIANTS

MARKERS = "osv^<>DPX*hp"


def styles():
    """{title: (colour, marker)}: the plain algorithm is black, every other variant has the same look on all figures."""
    colours = plt.get_cmap("tab20").colors
    others = [v.title for v in VARIANTS if v.title != PLAIN_TITLE]
    found = {title: (colours[(2 * i) % 20 + (2 * i) // 20 % 2], MARKERS[i % len(MARKERS)]) for i, title in enumerate(others)}
    return {PLAIN_TITLE: ("black", "o"), **found}


def drawable(points, key):
    """(point, error) of those that logarithmic axes can show."""
    return [(p, p["errors"][key]) for p in points if p["failure"] is None and p["errors"].get(key, 0) > 0]


def work_precision(part, keys):
    """Error over run time, a curve per method; the frontier is the line of rings."""
    look = styles()
    figure, axes = plt.subplots(1, len(keys), figsize=(6.2 * len(keys) + 2.6, 5.0), layout="constrained", squeeze=False)
    for axis, key in zip(axes[0], keys):
        for curve in part["curves"]:
            colour, marker = look[curve["method"]]
            shown = drawable(curve["points"], key)
            plain = curve["method"] == PLAIN_TITLE
            axis.plot([p["seconds"] for p, _ in shown], [e for _, e in shown], marker=marker, color=colour, markersize=5,
                      linewidth=2.2 if plain else 1.2, zorder=4 if plain else 3, label=curve["method"])
        best = [part["curves"][c]["points"][p] for c, p in part["frontier"][key]]
        best = [p for p in best if p["errors"][key] > 0]
        axis.plot([p["seconds"] for p in best], [p["errors"][key] for p in best], "o-", color="#c9a400", linewidth=5,
                  alpha=0.35, markersize=14, zorder=1, label="efficient frontier")
        for aim in part["aims"]:
            axis.axhline(aim, color="black", linewidth=0.6, linestyle=":")
        quantity = next(q for q in part["quantities"] if q["key"] == key)
        axis.set(xscale="log", yscale="log", xlabel="run time [s], one thread", ylabel="error")
        axis.set_title(quantity["title"], loc="left", fontsize=11)
        axis.grid(alpha=0.25, which="both", linewidth=0.5)
    axes[0][-1].legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5))
    return finish(figure)


def parameters(part, sweep, keys):
    """Error and run time over a parameter."""
    look = styles()
    figure, axes = plt.subplots(1, len(keys) + 1, figsize=(4.3 * (len(keys) + 1) + 2.2, 3.8), layout="constrained")
    for axis, key in zip(axes, keys):
        for curve in sweep["curves"]:
            shown = drawable(curve["points"], key)
            colour, marker = look[curve["method"]]
            axis.plot([p["value"] for p, _ in shown], [e for _, e in shown], marker=marker, color=colour, label=curve["method"])
        axis.set_title(next(q for q in part["quantities"] if q["key"] == key)["title"], loc="left", fontsize=10)
        axis.set(ylabel="error", yscale="log")
    for curve in sweep["curves"]:
        good = [p for p in curve["points"] if p["failure"] is None]
        colour, marker = look[curve["method"]]
        axes[-1].plot([p["value"] for p in good], [p["seconds"] for p in good], marker=marker, color=colour,
                      label=curve["method"])
    axes[-1].set_title("run time [s]", loc="left", fontsize=10)
    axes[-1].set_yscale("log")
    values = [p["value"] for curve in sweep["curves"] for p in curve["points"]]
    for axis in axes:
        axis.set_xscale("symlog" if min(values) <= 0 else "log", **({"linthresh": 0.02} if min(values) <= 0 else {}))
        axis.set_xlabel(sweep["title"])
        axis.grid(alpha=0.25, which="both", linewidth=0.5)
    axes[-1].legend(fontsize=8, loc="center left", bbox_to_anchor=(1.01, 0.5))
    return finish(figure)


def ensemble(section):
    """Mass of the oblique rod that is left in each run, and the means."""
    look = styles()
    rows = [r for r in section["rows"] if r["members"]]
    figure, axis = plt.subplots(figsize=(9, 0.4 * len(rows) + 1.6), layout="constrained")
    for i, row in enumerate(rows):
        colour, marker = look[row["method"]]
        axis.plot([m["left"] for m in row["members"]], [i] * len(row["members"]), marker, color=colour, alpha=0.6)
        axis.plot(row["mean"], i, "|", color="black", markersize=16)
    axis.axvline(section["reported"], color="black", linestyle=":", linewidth=1, label="the report's single run")
    axis.set_yticks(range(len(rows)), [r["method"] for r in rows])
    axis.set_xlabel("mass of the rod that is left / initial")
    axis.grid(axis="x", alpha=0.25)
    axis.legend(fontsize=8)
    return finish(figure)
