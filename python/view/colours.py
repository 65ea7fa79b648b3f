"""Colours of values: one scale for all pictures of a run, and its bar."""

import io

import matplotlib
import matplotlib.cm
import matplotlib.colors
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from PIL import Image

from view.fields import BadInput
from view.labels import power_of_ten, tick_texts

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


def colour_bar(colours, height, scale, ink):
    """A transparent PIL image of that height [pixel]: the bar with its numbers, name and unit; of bodies their names. scale:
    pixels of a point of type; ink: the colour of what is written, 0 to 255."""
    dots = 72.0 * scale
    written = tuple(c / 255.0 for c in ink)
    with matplotlib.rc_context({"text.color": written, "axes.edgecolor": written, "axes.labelcolor": written,
                                "xtick.color": written, "ytick.color": written}):
        figure = Figure(figsize=(2.0, height / dots), dpi=dots)
        if colours.names:
            patches = [Patch(color=c, label=n) for c, n in zip(colours.table, colours.names)]
            figure.legend(handles=patches, loc="center left", frameon=False, fontsize=10)
        else:
            draw_bar(figure, colours)
        stream = io.BytesIO()
        FigureCanvasAgg(figure)
        figure.savefig(stream, format="png", dpi=dots, transparent=True)
    image = Image.open(stream).convert("RGBA")
    return image.crop(matter(image, height))


def draw_bar(figure, colours):
    scalars = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(*colours.range),
                                           matplotlib.colors.ListedColormap(colours.table))
    bar = figure.colorbar(scalars, cax=figure.add_axes((0.2, 0.08, 0.1, 0.84)))
    bar.set_label(colours.label, fontsize=10)
    bar.outline.set_linewidth(0.5)
    factor, power = power_of_ten(max(abs(value) for value in colours.range))
    low, high = colours.range
    ticks = [tick for tick in bar.get_ticks() if low - 1e-9 * (high - low) <= tick <= high + 1e-9 * (high - low)]
    bar.set_ticks(ticks, labels=tick_texts([tick / factor for tick in ticks]))
    bar.ax.tick_params(labelsize=9)
    if power:
        bar.ax.set_title(power, fontsize=9, loc="left", y=1.0, pad=4)


def matter(image, height):
    """Box of the columns that are not empty, with all rows."""
    columns = np.flatnonzero((np.asarray(image.getchannel("A")) > 5).any(axis=0))
    left, right = (columns[0], columns[-1] + 1) if columns.size else (0, 1)
    return left, 0, right, height
