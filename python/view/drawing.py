"""The pictures of a run: one camera, one scale of colours, all times. VTK is asked for last: bad input is told at once."""

import os

import numpy as np

from view.camera import Camera, Frame, corners_of, parse_view
from view.colours import limits_of, make_colours
from view.fields import BadInput, read_vtu
from view.labels import time_scale
from view.quantity import Quantity, default_field, shown
from view.selection import body_names, chosen_bodies, elements_of, mirror_scales, parse_cut
from view.sheet import Layout, Sheet, Surround

FINEST_EDGES = 3.5  # pixels of an element, below which mesh lines would be all that is seen


def points_seen(mesh, elements, cut, scales):
    """Corners of boxes (n, 3) around all that is drawn of one time: pieces of 64 elements each, so that a turned camera
    sees little more than there is."""
    corners = mesh.points[mesh.hexahedra[elements]]
    if cut is not None:
        kept = ((corners - cut.origin) @ np.array(cut.normal) >= 0.0).any(axis=1)
        corners = corners[kept]
    if len(corners) == 0:
        return np.zeros((0, 3))
    starts = np.arange(0, len(corners), 64)
    low = np.minimum.reduceat(corners.min(axis=1), starts)
    high = np.maximum.reduceat(corners.max(axis=1), starts)
    if cut is not None:  # what lies behind the plane is not seen
        axis = int(np.argmax(np.abs(cut.normal)))
        bound = low if cut.normal[axis] > 0.0 else high
        clip = np.maximum if cut.normal[axis] > 0.0 else np.minimum
        bound[:, axis] = clip(bound[:, axis], cut.origin[axis])
    box = np.concatenate([corners_of(l, h) for l, h in zip(low, high)])
    return np.concatenate([box * np.array(scale) for scale in scales])


def element_size(mesh, elements):
    """Median length of the first edges of some elements [length]."""
    some = mesh.hexahedra[elements[:: max(len(elements) // 5000, 1)]]
    return float(np.median(np.linalg.norm(mesh.points[some[:, 0]] - mesh.points[some[:, 1]], axis=1))) if len(some) else 0.0


class Drawing:
    """What is drawn of the times `entries`, [(time, path)], by the options of the command line. Raises BadInput."""

    def __init__(self, entries, options):
        self.options = options
        self.window = None
        self.camera = Camera(*parse_view(options.view))
        self.cut = parse_cut(options.cut) if options.cut else None
        self.scales = mirror_scales(options.mirror)
        last = read_vtu(entries[-1][1])
        self.units, self.names = last.units, body_names(last)
        self.bodies = chosen_bodies(self.names, options.only, options.hide)
        self.quantity = Quantity(options.field or default_field([last]), last)
        self.survey(entries)

    def survey(self, entries):
        """One look at all times, for what they have in common: range of colours, frame, unit of time."""
        values, points = [], []
        for _, path in entries:
            mesh = read_vtu(path)
            elements = elements_of(mesh, self.bodies)
            points.append(points_seen(mesh, elements, self.cut, self.scales))
            here = self.quantity.of(mesh)
            here = here[np.unique(mesh.hexahedra[elements])] if self.quantity.on_points else here[elements]
            values.append(here)
            self.size = element_size(mesh, elements)
        points = np.concatenate(points)
        if len(points) == 0:
            raise BadInput("no element is left to draw in the chosen times, bodies and part of space")
        self.frame = Frame(self.camera, points)
        limits = self.options.range or limits_of(values, self.quantity.signed)
        self.colours = make_colours(self.quantity, limits, self.names, self.options.colours)
        self.factor, self.time_unit = time_scale([time for time, _ in entries], self.units.get("time", ""))

    def title(self, time, mesh, path):
        text = f"t = {time * self.factor:.4g} {self.time_unit}".strip()
        if self.options.beside:
            text = f"{os.path.basename(os.path.dirname(os.path.abspath(path)))}   {text}"
        alive, there = int(shown(mesh).sum()), len(mesh.hexahedra)
        return text if alive == there else f"{text}   ({alive} of {there} elements)"

    def edge_width(self, pixels):
        """Of mesh lines [pixel] in a drawing of that width."""
        if not self.options.edges:
            return 0.0
        size = self.size * pixels / self.frame.width
        return 0.0 if size < FINEST_EDGES else min(max(size / 16.0, 0.5), 1.0)

    def surfaces(self, mesh):
        """What is seen, and its mirror images."""
        from view.surface import mirrored, visible_surface

        surface = visible_surface(mesh, self.quantity, elements_of(mesh, self.bodies), self.cut)
        images = [[axis for axis, factor in zip("xyz", scale) if factor < 0.0] for scale in self.scales]
        return [mirrored(surface, scale, self.quantity.changes_sign(axes)) if axes else surface
                for scale, axes in zip(self.scales, images)]

    def sheets(self, groups, width, most_height, shadow_pixel=1):
        """A Sheet for each group of entries, all in one layout, as they are made; as wide as `width` [pixel], and at most so
        much of that high. shadow_pixel: so many pixels have one of their shadows."""
        groups = list(groups)
        layout = Layout(max(len(group) for group in groups), self.frame.aspect, width, most_height)
        surround = Surround(layout, self.frame, self.units.get("length"), self.colours)
        self.open_window(*layout.panel, shadow_pixel)
        for group in groups:
            drawings, titles = zip(*[self.draw(layout, entry) for entry in group])
            yield Sheet(layout, drawings, titles, surround)

    def open_window(self, width, height, shadow_pixel):
        """One window for all that is drawn: shaders are compiled once."""
        if self.window is None:
            from view.render import Window

            self.window = Window(self.frame)
        self.window.resize(width, height, shadow_pixel)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        """Before the display goes."""
        if self.window is not None:
            self.window.close()
        self.window = None

    def draw(self, layout, entry):
        """(image, title) of one time."""
        time, path = entry
        mesh = read_vtu(path)
        return self.window.draw(self.surfaces(mesh), self.colours, self.edge_width(layout.panel[0])), self.title(time, mesh, path)
