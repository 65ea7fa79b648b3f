"""Numbers, times and units as people read them."""

import math


def time_scale(times, unit):
    """(factor, unit) that make times readable: seconds become ms, us or ns where they are short."""
    largest = max((abs(t) for t in times if math.isfinite(t)), default=0.0)
    if unit == "s" and largest > 0.0:
        for factor, name in ((1.0, "s"), (1e3, "ms"), (1e6, "µs"), (1e9, "ns")):
            if largest * factor >= 1.0:
                break
        return factor, name
    return 1.0, unit


def readable_powers(text):
    return text.replace("^2", "²").replace("^3", "³").replace("^4", "⁴")


def with_unit(name, unit):
    return readable_powers(f"{name} [{unit}]" if unit else name)


def round_length(length):
    """The largest of 1, 2 or 5 times a power of ten that is not above the length (> 0)."""
    power = 10.0 ** math.floor(math.log10(length))
    return max(factor * power for factor in (1.0, 2.0, 5.0) if factor * power <= length * (1.0 + 1e-9))
