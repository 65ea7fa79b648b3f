"""Explicit dynamics of solids in contact and impact, around the pinball algorithm.

help(pinball.Simulation) and help(pinball.Scene) list what there is; units are those of the scene.
"""

from ._core import *
from ._core import version as __version__
from .comparison import Comparison as Comparison, compare as compare
from .convergence import Convergence as Convergence, converge as converge
from .results import Fields as Fields, History as History, read_fields as read_fields, read_history as read_history
from .runs import run as run
from .viewer import RunView as RunView, view as view
