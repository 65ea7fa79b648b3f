"""Measurements, one value each, and the ratios of those that were taken in the same round."""

from dataclasses import dataclass, field, replace

# Bytes of a register: the instruction sets of x86-64, which are the ones that the builds are made for.
REGISTERS = {64: "AVX-512", 32: "AVX2", 16: "SSE2"}


@dataclass(frozen=True)
class Sample:
    what: str
    size: int  # elements or pinballs
    precision: str
    threads: int
    instruction_set: str
    value: float
    unit: str
    round: int

    @property
    def series(self):
        """What all repetitions of a measurement have in common."""
        return (self.what, self.size, self.precision, self.threads, self.instruction_set, self.unit)


def instruction_set(simd_width, precision):
    """Of a program that works on so many numbers at a time."""
    if simd_width == 1:
        return "one lane"
    size = simd_width * {"double": 8, "float": 4, "mixed": 4}[precision]
    return REGISTERS.get(size, f"{8 * size} bits")


class Log:
    """Samples of one round after the other, by programs of one build."""

    def __init__(self, built_for):
        self.built_for = built_for
        self.round = 0
        self.samples = []

    def add(self, what, size, precision, threads, value, unit, built_for=None):
        self.samples.append(Sample(what, size, precision, threads, built_for or self.built_for, value, unit, self.round))


@dataclass
class Ratio:
    """Samples that have the values `of` over those that have `by` instead and all else in common."""

    what: str
    of: dict
    by: dict = field(default_factory=dict)
    inverse: bool = False  # of rates, where their costs are compared, and the other way round


def having(samples, values):
    return [s for s in samples if all(getattr(s, name) == value for name, value in values.items())]


def ratios(samples, definition):
    """As samples with the size, precision and threads of those divided. Only where both were measured in one round: a
    machine changes its speed in between."""
    divisors = having(samples, definition.by)
    found = []
    for sample in having(samples, definition.of):
        alike = {name: getattr(sample, name) for name in ("size", "precision", "threads", "round") if name not in definition.by}
        for divisor in having(divisors, alike):
            if divisor is not sample:
                value = sample.value / divisor.value
                found.append(replace(sample, what=definition.what, value=1 / value if definition.inverse else value,
                                     unit="ratio"))
    return found
