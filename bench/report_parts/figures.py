"""The figures of the page, as PNG in base64."""

import base64
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from .builds import BASE, NATIVE

COLOURS = {BASE: "#9aa5b1", "avx2": "#e9a03b", NATIVE: "#c22f4e"}
METHOD_COLOURS = {"slideline": "#2a6f97", "pinball": "#c22f4e"}
DPI = 110


def build_label(preset, width):
    if preset == BASE:
        return "vectorization off (one lane)"
    return f"{64 * width}-bit vectors, {width} lanes ({preset})"


def finish(figure):
    """The figure as the text of an <img>; it must show something."""
    drawn = sum(len(a.patches) + len(a.lines) + len(a.collections) for a in figure.axes)
    assert drawn > 0, "an empty figure"
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=DPI)
    plt.close(figure)
    return base64.b64encode(file.getvalue()).decode("ascii")


def stages(series):
    """Figures 10 and 11: time of a step by stage, both algorithms, with vectorization on and off."""
    presets = list(series["builds"])
    figure, axes = plt.subplots(1, 2, figsize=(12, 4.6), sharey=True, layout="constrained")
    for axis, (number, method) in zip(axes, (("10", "slideline"), ("11", "pinball"))):
        names = list(series["builds"][presets[0]][method]["stages"])
        at = np.arange(len(names))
        for i, preset in enumerate(presets):
            one = series["builds"][preset][method]
            scale = 1e3 / one["steps"]
            spread = [one["stages"][n] for n in names]
            middle = np.array([s["median"] for s in spread]) * scale
            error = np.array([[s["median"] - s["min"] for s in spread], [s["max"] - s["median"] for s in spread]]) * scale
            axis.bar(at + (i - 1) * 0.27, middle, 0.25, yerr=error, color=COLOURS[preset], error_kw=dict(linewidth=0.8),
                     label=build_label(preset, series["builds"][preset]["simd_width"]))
        axis.set_xticks(at, [n.replace(": ", ":\n").replace("element update", "element\nupdate")
                             .replace("node update", "node\nupdate") for n in names], fontsize=9)
        axis.set_title(f"Figure {number}: {method}", loc="left", fontsize=11)
        axis.grid(axis="y", alpha=0.25)
        axis.set_axisbelow(True)
    axes[0].set_ylabel("time of a step [ms], median and range")
    axes[1].legend(fontsize=9)
    return finish(figure)


def speed_ups(kernels, aim):
    """Speed-up of each kernel over one lane."""
    presets = [p for p in kernels[0]["builds"] if p != BASE]
    figure, axis = plt.subplots(figsize=(9, 4.6), layout="constrained")
    at = np.arange(len(kernels))[::-1]
    for i, preset in enumerate(presets):
        values = [k["builds"][preset]["speed_up"] for k in kernels]
        bars = axis.barh(at + (0.5 - i) * 0.36, values, 0.34, color=COLOURS[preset],
                         label=build_label(preset, kernels[0]["builds"][preset]["simd_width"]))
        axis.bar_label(bars, fmt="%.1f", fontsize=8, padding=2)
    axis.axvline(1, color="black", linewidth=0.8)
    axis.axvline(aim, color="black", linewidth=0.8, linestyle=":", label=f"aim for contact kernels (*): {aim:g}")
    axis.set_yticks(at, [k["title"] + (" *" if k["contact"] else "") for k in kernels])
    axis.set_xlabel("times as fast as with one lane, one thread")
    axis.grid(axis="x", alpha=0.25)
    axis.set_axisbelow(True)
    axis.legend(fontsize=9, loc="lower right")
    return finish(figure)


def roofline(section):
    """Operations a second over operations a byte, under the ceilings measured in the same series."""
    figure, axis = plt.subplots(figsize=(9.5, 5.6), layout="constrained")
    kernels = [k for k in section["kernels"] if k["builds"][NATIVE]["gflop_per_s"] > 0]
    intensities = [k["builds"][NATIVE]["operations_per_byte"] for k in kernels]
    x = np.geomspace(min(intensities + [0.1]) / 2, max(intensities + [10]) * 3, 200)
    for preset in (BASE, NATIVE):
        ceiling = section["ceilings"][preset]
        peak, triad = ceiling["peak_gflop_per_s"]["median"], ceiling["triad_gb_per_s"]["median"]
        width = ceiling["simd_width"]
        axis.plot(x, np.minimum(peak, triad * x), color=COLOURS[preset], linewidth=1.6,
                  label=f"roof, {build_label(preset, width)}: {peak:.0f} GFLOP/s, {triad:.1f} GB/s")
    for number, kernel in enumerate(kernels, 1):
        for preset, marker in ((BASE, "o"), (NATIVE, "s")):
            one = kernel["builds"][preset]
            axis.plot(one["operations_per_byte"], one["gflop_per_s"], marker, color=COLOURS[preset], markersize=6,
                      markeredgecolor="white", markeredgewidth=0.6)
        ends = [kernel["builds"][p] for p in (BASE, NATIVE)]
        axis.plot([e["operations_per_byte"] for e in ends], [e["gflop_per_s"] for e in ends], color="#9aa5b1", linewidth=0.8,
                  zorder=1)
        axis.annotate(str(number), (ends[1]["operations_per_byte"], max(e["gflop_per_s"] for e in ends)), xytext=(0, 6),
                      textcoords="offset points", ha="center", fontsize=9)
    names = "\n".join(f"{i}  {k['title']}" for i, k in enumerate(kernels, 1))
    axis.text(1.02, 1.0, names, transform=axis.transAxes, va="top", fontsize=9, linespacing=1.6)
    axis.set(xscale="log", yscale="log", xlabel="floating-point operations per byte that has to move at least",
             ylabel="GFLOP/s, double precision, one thread")
    axis.grid(alpha=0.25, which="both", linewidth=0.5)
    axis.legend(fontsize=8.5, loc="upper left")
    return finish(figure)


def totals(section):
    """Time of whole runs by method: contact and the rest, over the mesh sizes."""
    columns = section["columns"]
    figure, axes = plt.subplots(1, 2, figsize=(11, 4.2), layout="constrained")
    at = np.arange(len(columns))
    labels = [c["title"].replace(", ", ",\n").replace(" elements", "") + f"\n{c['elements']:,} el." for c in columns]
    for i, method in enumerate(("slideline", "pinball")):
        contact = [100 * c["methods"][method]["seconds"]["contact"]["median"]
                   / c["methods"]["slideline"]["seconds"]["total"]["median"] for c in columns]
        total = [100 * c["methods"][method]["seconds"]["total"]["median"]
                 / c["methods"]["slideline"]["seconds"]["total"]["median"] for c in columns]
        place = at + (i - 0.5) * 0.38
        axes[0].bar(place, contact, 0.35, color=METHOD_COLOURS[method], label=f"{method}: contact")
        axes[0].bar(place, np.array(total) - contact, 0.35, bottom=contact, color=METHOD_COLOURS[method], alpha=0.35,
                    label=f"{method}: the rest")
    axes[0].set_ylabel("time / total time with the slideline [%]")
    axes[0].set_ylim(0, 135)
    axes[0].legend(fontsize=8, ncols=2, loc="upper right")
    for key, colour in (("contact", "#4a1259"), ("total", "#f08a3c")):
        aim = section["aims"][key]["bound"]
        axes[1].plot(at, [c["ratio"][key] for c in columns], "o-", color=colour, label=f"{key}, measured")
        axes[1].axhline(aim, color=colour, linestyle=":", linewidth=1.2, label=f"{key}, aim: {aim:g}")
    axes[1].axhline(1, color="black", linewidth=0.8)
    axes[1].set(yscale="log", ylabel="slideline / pinball")
    axes[1].set_yticks([0.2, 0.5, 1, 2, 5, 10, 20], ["0.2", "0.5", "1", "2", "5", "10", "20"])
    axes[1].minorticks_off()
    ratios = [c["ratio"][key] for c in columns for key in ("contact", "total")]
    axes[1].set_ylim(0.8 * min(ratios + [1]), 1.6 * max(ratios + [5]))
    axes[1].set_xlim(-0.5, len(columns) - 0.5)
    axes[1].legend(fontsize=8, ncols=2, loc="upper right")
    for axis in axes:
        axis.set_xticks(at, labels, fontsize=8)
        axis.grid(axis="y", alpha=0.25)
        axis.set_axisbelow(True)
    return finish(figure)


def sliding(section):
    """Height of a sliding block over time."""
    figure, axis = plt.subplots(figsize=(9, 3.6), layout="constrained")
    for method, style in (("slideline", "--"), ("pinball", "-")):
        one = section["methods"][method]
        axis.plot(np.array(one["time"]) * 1e3, one["height"], style, color=METHOD_COLOURS[method], linewidth=1.4,
                  label=f"{method}: varies by {one['bumps']:.2g} elements after it has settled")
    axis.axvline(section["rest"] * 1e3, color="black", linewidth=0.8, linestyle=":")
    axis.set(xlabel="time [ms]", ylabel="height over flat contact\n[elements of the floor]")
    axis.grid(alpha=0.25)
    axis.legend(fontsize=9)
    return finish(figure)
