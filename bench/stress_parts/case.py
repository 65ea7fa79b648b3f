"""A row of the table: what is run, which outcomes are right, and what came out."""

import os
from collections.abc import Callable
from dataclasses import asdict, dataclass, field

from . import program
from .judge import ACCURATE, CRASHES, HANGS, STOPS, UNCLEAR, WRONG, judge

BAD = (WRONG, CRASHES, HANGS, UNCLEAR)


@dataclass
class Row:
    group: str
    title: str
    outcome: str
    right: bool
    text: str  # the figure nearest to its tolerance, or the message
    figures: list = field(default_factory=list)
    steps: int = 0
    seconds: float = 0.0
    expected: tuple = ()


@dataclass
class Case:
    group: str
    title: str
    scene: dict
    expected: tuple = (ACCURATE,)  # outcomes that are right
    figures: Callable | None = None  # of the run, more than the general ones
    named: str = ""
    most_steps: int | None = None
    slow: bool = False  # not in the quick form
    timeout: float = 300.0  # a hang, and not a busy machine

    def row(self, folder):
        run = program.run(self.scene, folder, timeout=self.timeout)
        verdict = judge(run, self.scene, self.figures, self.named, self.most_steps)
        return Row(self.group, self.title, verdict.outcome, verdict.outcome in self.expected,
                   verdict.text().replace(os.path.abspath(folder) + os.sep, ""),
                   [{**asdict(figure), "holds": figure.holds} for figure in verdict.figures], run.summary.get("steps", 0),
                   run.seconds, self.expected)


EITHER = (ACCURATE, STOPS)
