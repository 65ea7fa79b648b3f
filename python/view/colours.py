"""Colours of values: one scale for all pictures of a run, and its bar."""

import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.colors
import matplotlib.pyplot as plt
import numpy as np
from PIL import Image

from view.fields import BadInput

# From untouched metal to dark: lightness falls all the way, by steps that look the same (places by the distance in CIELAB),
# and light shading and mesh lines show where nothing happens.
FROM_GREY = [(0.0, "#e3e6ea"), (0.283, "#efc56a"), (0.459, "#e5823f"), (0.71, "#bb3553"), (1.0, "#451558")]
SEQUENTIAL = matplotlib.colors.LinearSegmentedColormap.from_list("from grey", FROM_GREY)
DIVERGING = matplotlib.colormaps["RdBu_r"]
BODIES = ["#8fa3b8", "#d9a15b", "#7fb08a", "#c27b8e", "#9c8cc4", "#b8b06a", "#6fb3bd", "#b0a090"]


class Colours:
    """table: (n, 4) RGBA from 0 to 1; range: the values at its ends; label: what the bar says."""

    def __init__(self, table, limits, label, names=()):
        self.table, self.range, self.label, self.names = table, limits, label, names


def limits_of(values, signed):
    """Range of the values of all times: from zero, or the same to both sides of it."""
    values = np.concatenate([v[np.isfinite(v)] for v in values] or [np.zeros(0)])
    low, high = values.min(initial=0.0), values.max(initial=0.0)
    largest = max(-low, high) or 1.0
    if signed:
        return -largest, largest
    return low, high if high > low else low + 1.0


def make_colours(quantity, limits, names, wanted=None):
    """The colours of a quantity between two values; of bodies, one for each name."""
    if quantity.name == "body":
        table = [matplotlib.colors.to_rgba(BODIES[i % len(BODIES)]) for i in range(len(names))]
        return Colours(np.array(table), (-0.5, len(names) - 0.5), "", names)
    if wanted and wanted not in matplotlib.colormaps:
        raise BadInput(f"--colours: no colour map {wanted} in Matplotlib; viridis, cividis, turbo and magma are some")
    colour_map = matplotlib.colormaps[wanted] if wanted else DIVERGING if quantity.signed else SEQUENTIAL
    return Colours(colour_map(np.linspace(0.0, 1.0, 256)), limits, quantity.label)


def colour_bar(colours, height, scale):
    """A PIL image of that height [pixel]: the bar with its numbers, name and unit; of bodies their names. scale: pixels of
    a point of type."""
    dots = 72.0 * scale
    figure = plt.figure(figsize=(1.6, height / dots), dpi=dots)
    if colours.names:
        patches = [matplotlib.patches.Patch(color=c, label=n) for c, n in zip(colours.table, colours.names)]
        figure.legend(handles=patches, loc="center left", frameon=False, fontsize=10)
    else:
        scalars = plt.cm.ScalarMappable(plt.Normalize(*colours.range), matplotlib.colors.ListedColormap(colours.table))
        axes = figure.add_axes((0.08, 0.08, 0.12, 0.84))
        bar = figure.colorbar(scalars, cax=axes)
        bar.set_label(colours.label, fontsize=10)
        bar.ax.tick_params(labelsize=9)
        bar.formatter.set_powerlimits((-3, 4))
        bar.formatter.set_useMathText(True)
        bar.outline.set_linewidth(0.5)
    stream = io.BytesIO()
    figure.savefig(stream, format="png", dpi=dots, bbox_inches=None)
    plt.close(figure)
    image = Image.open(stream).convert("RGB")
    return image.crop(matter(image, height))


def matter(image, height):
    """Box of the columns that are not white, with all rows."""
    columns = np.flatnonzero((np.asarray(image) < 250).any(axis=(0, 2)))
    left, right = (columns[0], columns[-1] + 1) if columns.size else (0, 1)
    return left, 0, right, height
