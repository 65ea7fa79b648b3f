"""Where the viewer stands, and what of space he sees."""

import itertools
import math

import numpy as np

from view.fields import BadInput

# Degrees: azimuth from the side, turning towards +x; elevation above the plane of x and y. z is up, in views along z y is.
VIEWS = {
    "iso": (25.0, 25.0),
    "side": (0.0, 0.0),
    "back": (180.0, 0.0),
    "right": (90.0, 0.0),
    "left": (-90.0, 0.0),
    "top": (0.0, 90.0),
    "bottom": (0.0, -90.0),
}


def parse_view(text):
    """(azimuth, elevation) of a name or of "AZIMUTH,ELEVATION" [degree]. Raises BadInput."""
    if text in VIEWS:
        return VIEWS[text]
    try:
        azimuth, elevation = (float(part) for part in text.split(","))
    except ValueError:
        raise BadInput(f"--view: expected {', '.join(VIEWS)} or AZIMUTH,ELEVATION in degrees, got {text}")
    if not (math.isfinite(azimuth) and -90.0 <= elevation <= 90.0):
        raise BadInput(f"--view: expected an elevation from -90 to 90 degrees, got {text}")
    return azimuth, elevation


class Camera:
    """A parallel projection: unit vectors to the right, up and toward the viewer."""

    def __init__(self, azimuth, elevation):
        a, e = math.radians(azimuth), math.radians(elevation)
        self.toward = np.array([math.sin(a) * math.cos(e), -math.cos(a) * math.cos(e), math.sin(e)])
        self.up = np.array([-math.sin(a) * math.sin(e), math.cos(a) * math.sin(e), math.cos(e)])
        self.right = np.cross(self.up, self.toward)

    def extents(self, points):
        """((lowest, highest) to the right, the same up, and toward the viewer) of points (n, 3)."""
        return [((points @ axis).min(), (points @ axis).max()) for axis in (self.right, self.up, self.toward)]


class Frame:
    """The rectangle of the picture's plane that is drawn: all that is given, and a margin."""

    MARGIN = 0.03

    def __init__(self, camera, points):
        self.camera = camera
        ranges = camera.extents(points)
        self.centre = sum(0.5 * (low + high) * axis for (low, high), axis in
                          zip(ranges, (camera.right, camera.up, camera.toward)))
        self.width, self.height, self.depth = (high - low for low, high in ranges)
        margin = 2.0 * self.MARGIN * max(self.width, self.height)
        self.width, self.height = self.width + margin, self.height + margin
        # Of a body seen from its thin side there is still a strip, and room for a title above it.
        self.width, self.height = max(self.width, 0.15 * self.height), max(self.height, 0.15 * self.width)

    @property
    def aspect(self):
        return self.height / self.width


def corners_of(low, high):
    """(8, 3): the corners of a box."""
    return np.array(list(itertools.product(*zip(low, high))))
