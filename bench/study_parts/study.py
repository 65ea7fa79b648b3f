"""What a study is made of: a scene with a reference, what differs from run to run, and what is measured in each."""

from collections.abc import Callable
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Quantity:
    """An error, relative: 0.01 is one percent."""

    key: str
    title: str
    norm: str  # what exactly is compared, and how


@dataclass(frozen=True)
class Variant:
    """A change of settings; one curve of a diagram."""

    group: str  # a study names the groups that have a meaning in it
    title: str
    settings: tuple = ()
    step: float = 0.9  # fraction of the stable time step
    precision: str = "double"


@dataclass(frozen=True)
class Setup:
    """A scene to run: one of data/scenes, with changes."""

    scene: str
    settings: list
    more: str = ""  # tables that are added to the scene's text
    replace: tuple = ()  # (old, new) in the scene's text
    refine: int = 1


@dataclass(frozen=True)
class Sweep:
    """One parameter over a range, on one mesh, for some variants."""

    title: str
    key: str
    values: dict  # {form: list}
    variants: tuple  # titles
    mesh: int
    scale: float = 1.0  # of the values: what the scene calls 1
    settings: Callable = None  # of a value, where it is not one key


@dataclass(frozen=True)
class Study:
    name: str
    title: str
    reference: str  # with its source
    quantities: tuple
    groups: tuple
    mesh: str  # what the numbers of `meshes` count
    meshes: dict  # {form: numbers of elements, from coarse to fine}
    report_mesh: int  # the one of the report, or the one of the scene as it stands
    setup: Callable  # (mesh, variant) -> Setup
    measure: Callable  # (run, mesh, variant) -> {key of a quantity: error}
    without: tuple = ()  # titles of variants that mean nothing here
    fine: dict = field(default_factory=dict)  # {form: largest mesh of variants that are not in `foremost`}
    foremost: tuple = ()
    sweeps: tuple = ()
    note: str = ""  # what is to be known when the numbers are read
