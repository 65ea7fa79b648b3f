"""What a run is worth: accurate, doubted by the program itself, stopped or refused with a clear message, or wrong."""

import math
import re
from dataclasses import dataclass, field

import numpy as np

ACCURATE, WARNS, STOPS, REFUSES = "accurate", "warns", "stops", "refuses"
WRONG, CRASHES, HANGS, UNCLEAR = "SILENTLY WRONG", "CRASHES", "HANGS", "UNCLEAR"

LARGEST_ENERGY_ERROR = 0.1  # from there on the program itself warns
LARGEST_DRIFT = 1e-10  # of momentum, of the sum of the masses times the speeds that the energy allows


@dataclass
class Figure:
    """A number of a run and what it should be."""
    name: str
    value: float
    reference: float
    tolerance: float

    def __post_init__(self):
        self.value, self.reference, self.tolerance = float(self.value), float(self.reference), float(self.tolerance)

    @property
    def holds(self):
        return bool(math.isfinite(self.value) and abs(self.value - self.reference) <= self.tolerance)

    def text(self):
        return f"{self.name} {self.value:.4g}, expected {self.reference:.4g} within {self.tolerance:.2g}"


def at_most(name, value, bound):
    """Of a number that is 0 at best."""
    return Figure(name, value, 0.0, bound)


@dataclass
class Verdict:
    outcome: str
    figures: list = field(default_factory=list)
    message: str = ""

    def text(self):
        """One line: the message of the program, or the figure nearest to its tolerance."""
        if self.message:
            return self.message
        if not self.figures:
            return ""
        return max(self.figures, key=lambda f: abs(f.value - f.reference) / f.tolerance if f.tolerance > 0 and math.isfinite(f.value)
                   else 0.0 if f.holds else math.inf).text()


def numbers_of(item):
    """All numbers of the summary; null (of NaN or infinity) is NaN."""
    if isinstance(item, dict):
        return [n for part in item.values() for n in numbers_of(part)]
    if isinstance(item, list):
        return [n for part in item for n in numbers_of(part)]
    if item is None:
        return [math.nan]
    return [float(item)] if isinstance(item, (int, float)) and not isinstance(item, bool) else []


def is_finite(run):
    parts = [run.summary[key] for key in ("energy", "momentum", "bodies", "end_time")]
    return all(map(math.isfinite, numbers_of(parts))) and all(np.isfinite(column).all() for column in run.history.values())


def is_free(scene):
    """Whether nothing outside of the bodies acts on them."""
    return not any(scene.get(key) for key in ("constraint", "rigid_wall", "load", "prescribed_velocity", "damping"))


def general_figures(run, scene):
    """Laws that hold for every scene: the balance of energy, and of momentum where nothing acts from outside."""
    energy, momentum = run.summary["energy"], run.summary["momentum"]
    figures = [at_most("energy balance error", energy["balance_error_max"], LARGEST_ENERGY_ERROR)]
    if is_free(scene):
        mass = sum(body["mass_initial"] for body in run.summary["bodies"])
        scale = max(math.sqrt(2 * mass * max(0.0, energy["initial_total"])), *(abs(p) for p in momentum["initial"]), 1e-300)
        drift = max(abs(a - b) for a, b in zip(momentum["initial"], momentum["final"])) / scale
        rounding = LARGEST_DRIFT if run.summary["precision"] == "double" else 1e-3
        figures.append(at_most("momentum drift", drift, rounding))
    return figures


def of_error(run, named=""):
    """The verdict on a run that ended with status 1 or 2."""
    message = run.message
    foreseen = bool(message) and not re.search(r"std::|bad_alloc|vector|basic_string|terminate", message)
    if run.status == 2:
        clear = foreseen and re.search(r"\.toml|\.msh|--", message) and re.search(r"expected|more than|needs", message)
        return Verdict(REFUSES if clear else UNCLEAR, message=message or run.said[-200:])
    clear = foreseen and re.search(r"in step \d+ at time", message) and re.search(named, message) and run.last_good
    return Verdict(STOPS if clear else UNCLEAR, message=message or run.said[-200:])


def judge(run, scene, figures=None, named="", most_steps=None):
    """figures: function of the run that gives more of them. named: what the message of a stop has to match; most_steps:
    how many steps it may take until then."""
    if run.status is None:
        return Verdict(HANGS, message=f"did not end within {run.seconds:.0f} s")
    if run.status not in (0, 1, 2):
        return Verdict(CRASHES, message=f"status {run.status}: {run.said[-200:]}")
    if run.status != 0:
        verdict = of_error(run, named)
        if verdict.outcome == STOPS and most_steps and run.summary["steps"] > most_steps:
            return Verdict(WRONG, message=f"only after {run.summary['steps']} steps: {verdict.message}")
        return verdict
    if not run.summary or not is_finite(run):
        return Verdict(WRONG, message="numbers that are not finite")
    found = general_figures(run, scene) + (figures(run) if figures else [])
    if all(figure.holds for figure in found):
        return Verdict(ACCURATE, found)
    if run.summary["warnings"]:
        return Verdict(WARNS, found, "; ".join(run.summary["warnings"]))
    return Verdict(WRONG, found)
