"""What others reach. None of it was measured in the run that it stands beside: such a ratio is a guide, no more."""

from dataclasses import dataclass

from . import scenes, whole_steps

FROM = "given with the aims of this project"
RADIOSS_ROD = f"OpenRadioss, its own scene of a rod that strikes a plate; {FROM}"
RADIOSS_BAR = f"OpenRadioss, Taylor bar of 20,000 elements; {FROM}"
NIMBLE = f"NimbleSM, contact of 38,400 facets, tree built at every step; {FROM}"
LULESH = f"LULESH 2.0 -s 60, zone cycles; {FROM}; --lulesh measures it in the same run"


@dataclass(frozen=True)
class Figure:
    what: str
    threads: int
    low: float
    high: float
    source: str
    elements: int  # of the mesh that it is for
    smaller_is_better: bool = False

    def of_series(self, what, size, precision, threads):
        """Whether it belongs beside this series: sizes within 5 %."""
        return (what, precision, threads) == (self.what, "double", self.threads) and abs(size / self.elements - 1) < 0.05

    def gain(self, value):
        """How many times as fast a value is: (least, most)."""
        return (self.low / value, self.high / value) if self.smaller_is_better else (value / self.high, value / self.low)


def _times(title, elements, one, two):
    return [Figure(scenes.time_of(title), threads, value, value, RADIOSS_ROD, elements, smaller_is_better=True)
            for threads, value in ((1, one), (2, two))]


_ROD, _REFINED, _BAR, _FACETS = (case.title for case in scenes.CASES[:4])
FIGURES = [
    *_times(_ROD, 1_844, 0.66, 0.53),
    *_times(_REFINED, 14_752, 10.0, 7.2),
    Figure(scenes.speed_of(_BAR), 1, 2.8, 3.7, RADIOSS_BAR, 20_000),
    Figure(scenes.speed_of(_BAR), 2, 4.8, 7.0, RADIOSS_BAR, 20_000),
    Figure(scenes.contact_time_of(_FACETS), 1, 9.3, 9.3, NIMBLE, 256_000, smaller_is_better=True),
    Figure(whole_steps.STEP, 1, 1.5, 1.7, LULESH, 60**3),
    Figure(whole_steps.STEP, 2, 2.2, 2.6, LULESH, 60**3),
]


def figure_for(what, size, precision, threads):
    return next((f for f in FIGURES if f.of_series(what, size, precision, threads)), None)
