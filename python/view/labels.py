"""Numbers, times and units as people read them."""

import math


SHORTER = {"s": ["ms", "µs", "ns"], "ms": ["µs", "ns"], "us": ["ns"], "µs": ["ns"]}


def time_scale(times, unit):
    """(factor, unit) that make times readable, as the page of a run has them (solver/output/page/axes.js): seconds become
    ms, µs or ns where they are short."""
    largest = max((abs(t) for t in times if math.isfinite(t)), default=0.0)
    if not 0.0 < largest < 0.1 or unit not in SHORTER:
        return 1.0, unit
    steps = min(-math.floor(math.log10(largest) / 3.0), len(SHORTER[unit]))
    return 1000.0 ** steps, SHORTER[unit][steps - 1]


def power_of_ten(largest):
    """(factor, text) of the power of ten that numbers up to this size are written with: (1.0, "") for what needs none."""
    if not 0.0 < largest < math.inf or 1e-3 <= largest < 1e4:
        return 1.0, ""
    power = max(math.floor(math.log10(largest)), -300)
    return 10.0 ** power, "×10" + str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def tick_texts(values):
    """Numbers of ticks with as many digits as make neighbours differ."""
    values = [float(value) for value in values]
    steps = [abs(b - a) for a, b in zip(values, values[1:]) if b != a]
    largest = max((abs(value) for value in values), default=0.0)
    digits = min(max(math.ceil(math.log10(largest / min(steps))) + 2, 2), 15) if steps else 5
    return [f"{0.0 if abs(value) < 1e-12 * largest else value:.{digits}g}".replace("-", "−") for value in values]


def readable_powers(text):
    return text.replace("^2", "²").replace("^3", "³").replace("^4", "⁴")


def with_unit(name, unit):
    return readable_powers(f"{name} [{unit}]" if unit else name)


def round_length(length):
    """The largest of 1, 2 or 5 times a power of ten that is not above the length (> 0)."""
    power = 10.0 ** math.floor(math.log10(length))
    return max(factor * power for factor in (1.0, 2.0, 5.0) if factor * power <= length * (1.0 + 1e-9))
