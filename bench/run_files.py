"""Readers of what a run leaves: those of the viewer, python/view."""

import os
import sys

sys.path.insert(1, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "python"))

from view.fields import BadInput, read_pvd, read_vtu  # noqa: E402, F401
from view.history import read_history  # noqa: E402, F401
