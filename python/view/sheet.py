"""Drawings put together: titles, axes and a measure on each, several side by side, and the bar of colours."""

import math

from matplotlib import font_manager
from PIL import Image, ImageDraw, ImageFont

from view.labels import round_length, with_unit

INK = (40, 40, 45)
AXES = {"x": (190, 60, 50), "y": (60, 140, 60), "z": (50, 90, 180)}


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
    """Sizes [pixel] of a sheet of `panels` drawings: they and the bar fill `width`."""

    def __init__(self, panels, aspect, width, most_height=1.1):
        self.columns = number_of_columns(panels, aspect)
        self.rows = math.ceil(panels / self.columns)
        self.scale = max(width / (900.0 if self.columns > 1 else 700.0), 0.8)  # pixels of a point of type
        self.title = round(20 * self.scale)
        self.gap = round(8 * self.scale)
        self.bar = round(88 * self.scale)
        panel = (width - self.bar) // self.columns - self.gap
        most = (most_height * width / self.rows - self.title) / aspect
        self.panel = max(int(min(panel, most)), 16), max(int(min(panel, most) * aspect), 16)
        self.width = self.columns * (self.panel[0] + self.gap) + self.bar
        self.height = max(self.rows * (self.panel[1] + self.title), round(150 * self.scale))
        self.width, self.height = self.width + self.width % 2, self.height + self.height % 2  # as films need them

    def place(self, i):
        return (i % self.columns) * (self.panel[0] + self.gap), (i // self.columns) * (self.panel[1] + self.title)


def put_together(layout, drawings, titles, bar):
    """A PIL image of the drawings (PIL images), each with its title, and the bar to their right."""
    sheet = Image.new("RGB", (layout.width, layout.height), "white")
    draw = ImageDraw.Draw(sheet)
    for i, (drawing, title) in enumerate(zip(drawings, titles)):
        x, y = layout.place(i)
        sheet.paste(drawing, (x, y + layout.title))
        draw.text((x + layout.panel[0] / 2, y + layout.title / 2), title, INK, font(11 * layout.scale), anchor="mm")
    sheet.paste(bar, (layout.columns * (layout.panel[0] + layout.gap), (layout.height - bar.height) // 2))
    return sheet


def draw_axes(drawing, camera, scale):
    """Directions of x, y and z in the lower left corner, those toward the viewer last."""
    draw = ImageDraw.Draw(drawing)
    length = 22 * scale
    origin = 34 * scale, drawing.height - 34 * scale
    for i, name in sorted(enumerate("xyz"), key=lambda axis: camera.toward[axis[0]]):
        along = camera.right[i], -camera.up[i]
        if math.hypot(*along) < 0.05:
            continue
        end = tuple(o + length * a for o, a in zip(origin, along))
        draw.line([origin, end], AXES[name], round(2 * scale))
        size = math.hypot(*along)
        at = tuple(e + 7 * scale * a / size for e, a in zip(end, along))
        draw.text(at, name, AXES[name], font(10 * scale), anchor="mm")


def draw_measure(drawing, frame, unit, scale):
    """A bar of a round length in the lower right corner."""
    length = round_length(0.22 * frame.width)
    pixels = length / frame.width * drawing.width
    draw = ImageDraw.Draw(drawing)
    y, right = drawing.height - 10 * scale, drawing.width - 10 * scale
    draw.line([(right - pixels, y), (right, y)], INK, round(2 * scale))
    text = with_unit(f"{length:.6g}", None) + (f" {unit}" if unit else "")
    draw.text((right - pixels / 2, y - 4 * scale), text, INK, font(9 * scale), anchor="mb")
