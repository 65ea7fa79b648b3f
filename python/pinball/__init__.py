"""Explicit dynamics of solids in contact and impact, around the pinball algorithm.

help(pinball.Simulation) and help(pinball.Scene) list what there is; units are those of the scene.
"""

from ._core import *
from ._core import version as __version__
from .comparison import Comparison, compare
from .convergence import Convergence, converge
from .results import Fields, History, read_fields, read_history
from .runs import run
from .viewer import RunView, view
