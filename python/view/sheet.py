"""Drawings put together: titles above, axes and a measure below them, and the bar of colours."""

import math
from functools import lru_cache

from matplotlib import font_manager
from PIL import Image, ImageDraw, ImageFont

from view.colours import colour_bar
from view.labels import round_length, with_unit

AXES = {"x": (190, 60, 50), "y": (60, 140, 60), "z": (50, 90, 180)}


class Ink:
    """Colours of what is written: on paper, or on a page that is light or dark and is seen through the picture."""

    def __init__(self, text, paper, lighter=0.0):
        self.text, self.paper = text, paper
        self.axes = {name: tuple(round(c + lighter * (255 - c)) for c in colour) for name, colour in AXES.items()}


PAPER = Ink((40, 40, 45), (255, 255, 255, 255))
LIGHT = Ink((40, 40, 45), (255, 255, 255, 0))
DARK = Ink((222, 226, 231), (20, 23, 27, 0), lighter=0.35)


@lru_cache
def font(size):
    return ImageFont.truetype(font_manager.findfont("DejaVu Sans"), round(size))


def number_of_columns(panels, aspect):
    """How many columns give the largest panels on a page of 2 : 1 without leaving more room empty than needed."""
    def panel_width(columns):
        rows = math.ceil(panels / columns)
        empty = (rows * columns - panels) / panels
        return min(1.0 / columns, 0.5 / (rows * (aspect + 0.1))) * (1.0 - 0.75 * empty)

    return max(range(1, panels + 1), key=panel_width)


class Layout:
    """Sizes [pixel] of a sheet of `panels` drawings: they and the bar fill `width`. Below them is a strip for the axes and a
    measure."""

    def __init__(self, panels, aspect, width, most_height=1.1):
        self.columns = number_of_columns(panels, aspect)
        self.rows = math.ceil(panels / self.columns)
        self.scale = max(width / (900.0 if self.columns > 1 else 700.0), 0.8)  # pixels of a point of type
        self.title = round(20 * self.scale)
        self.gap = round(8 * self.scale)
        self.bar = round(88 * self.scale)
        self.strip = round(52 * self.scale)
        panel = (width - self.bar) // self.columns - self.gap
        most = ((most_height * width - self.strip) / self.rows - self.title) / aspect
        self.panel = max(int(min(panel, most)), 16), max(int(min(panel, most) * aspect), 16)
        self.width = self.columns * (self.panel[0] + self.gap) + self.bar
        self.drawn = self.rows * (self.panel[1] + self.title)  # height of the drawings
        self.height = max(self.drawn + self.strip, round(180 * self.scale))
        self.width, self.height = self.width + self.width % 2, self.height + self.height % 2  # as films need them

    def place(self, i):
        return (i % self.columns) * (self.panel[0] + self.gap), (i // self.columns) * (self.panel[1] + self.title)


class Sheet:
    """Drawings (PIL images, transparent where nothing is), each with its title, before a strip and a bar of colours."""

    def __init__(self, layout, drawings, titles, surround):
        self.layout, self.drawings, self.titles, self.surround = layout, drawings, titles, surround

    def on(self, ink):
        """A PIL image (RGBA) of all."""
        sheet = self.surround(ink).copy()
        draw = ImageDraw.Draw(sheet)
        for i, (drawing, title) in enumerate(zip(self.drawings, self.titles)):
            x, y = self.layout.place(i)
            sheet.alpha_composite(drawing, (x, y + self.layout.title))
            draw.text((x + self.layout.panel[0] / 2, y + self.layout.title / 2), title, ink.text, font(11 * self.layout.scale),
                      anchor="mm")
        return sheet

    def on_paper(self):
        return self.on(PAPER).convert("RGB")


class Surround:
    """What all sheets of one layout have around their drawings: axes, a measure, the bar. Made once for each ink, bars once
    for each colour of text."""

    def __init__(self, layout, frame, unit, colours):
        self.layout, self.frame, self.unit, self.colours = layout, frame, unit, colours
        self.made, self.bars = {}, {}

    def __call__(self, ink):
        if ink not in self.made:
            self.made[ink] = self.make(ink)
        return self.made[ink]

    def make(self, ink):
        layout = self.layout
        image = Image.new("RGBA", (layout.width, layout.height), ink.paper)
        if ink.text not in self.bars:
            height = min(layout.height, round(layout.width * 0.6))
            self.bars[ink.text] = colour_bar(self.colours, height, layout.scale, ink.text)
        bar = self.bars[ink.text]
        image.alpha_composite(bar, (layout.columns * (layout.panel[0] + layout.gap), (layout.height - bar.height) // 2))
        left = draw_axes(image, self.frame.camera, layout, ink)
        draw_measure(image, self.frame, self.unit, layout, ink, left)
        return image


def draw_axes(image, camera, layout, ink):
    """Directions of x, y and z in the left of the strip, those toward the viewer last. Returns where they end [pixel]."""
    draw, scale = ImageDraw.Draw(image), layout.scale
    length, gap = 17 * scale, 7 * scale
    ends = [(camera.right[i], -camera.up[i]) for i in range(3)]
    low, high = ([pick([0.0, *(end[k] for end in ends)]) for k in range(2)] for pick in (min, max))
    left = 2 * gap - low[0] * (length + gap)
    middle = layout.drawn + 0.5 * layout.strip - 0.5 * (low[1] + high[1]) * (length + gap)
    for i, name in sorted(enumerate("xyz"), key=lambda axis: camera.toward[axis[0]]):
        size = math.hypot(*ends[i])
        if size < 0.05:
            continue
        end = tuple(o + length * a for o, a in zip((left, middle), ends[i]))
        draw.line([(left, middle), end], ink.axes[name], round(2 * scale))
        at = tuple(e + gap * a / size for e, a in zip(end, ends[i]))
        draw.text(at, name, ink.axes[name], font(10 * scale), anchor="mm")
    return left + high[0] * (length + gap) + 2 * gap


def draw_measure(image, frame, unit, layout, ink, left):
    """A bar of a round length in the strip, to the right of the axes."""
    scale = layout.scale
    length = round_length(0.22 * frame.width)
    pixels = length / frame.width * layout.panel[0]
    draw = ImageDraw.Draw(image)
    text = with_unit(f"{length:.6g}", None) + (f" {unit}" if unit else "")
    right = max(layout.panel[0] - 10 * scale, left + pixels)
    y = layout.drawn + 0.5 * layout.strip + 6 * scale
    draw.line([(right - pixels, y), (right, y)], ink.text, round(2 * scale))
    draw.text((right - pixels / 2, y - 4 * scale), text, ink.text, font(9 * scale), anchor="mb")
