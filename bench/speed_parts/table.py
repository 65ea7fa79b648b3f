"""All series as one table, for people and for programs."""

import csv
import os
from dataclasses import astuple, fields

from report_parts.measuring import spread
from report_parts.pointers import three_digits

from .published import figure_for
from .samples import Sample

FILES = {
    "measurements.csv": "every measurement",
    "ratios.csv": "every ratio of two measurements of one round",
    "table.csv": "the table above",
}
SPREAD = ["median", "min", "lower_quartile", "upper_quartile"]
HEAD = ["what", "size", "precision", "threads", "instruction_set", "unit", "rounds", *SPREAD, "published", "times_as_fast"]
NUMBERS = {"size", "threads", "rounds", *SPREAD}


def bounds(low, high):
    return three_digits(low) if low == high else f"{three_digits(low)}-{three_digits(high)}"


def rows(samples):
    """One row of HEAD per series, in the order in which they first appear."""
    series = {}
    for sample in samples:
        series.setdefault(sample.series, []).append(sample.value)
    found = []
    for (what, size, precision, threads, built_for, unit), values in series.items():
        of = spread(values)
        figure = figure_for(what, size, precision, threads)
        beside = [bounds(figure.low, figure.high), bounds(*figure.gain(of["median"]))] if figure else ["", ""]
        found.append([what, size, precision, threads, built_for, unit, len(values), *(of[s] for s in SPREAD), *beside])
    return found


def read(folder):
    """The rows that write() has left there."""
    with open(os.path.join(folder, "table.csv"), newline="", encoding="utf-8") as file:
        return [[float(line[name]) if name in SPREAD else int(line[name]) if name in NUMBERS else line[name] for name in HEAD]
                for line in csv.DictReader(file)]


def sources(found):
    """Where the published figures of these rows are from, each once."""
    figures = [figure_for(*row[:4]) for row in found]
    return list(dict.fromkeys(figure.source for figure in figures if figure))


def head(machine):
    """machine: as machine.json has it."""
    return (f"{machine['cpu']}, {machine['cores']} cores, {machine['memory_gib']} GiB; {machine['compiler']}; "
            f"revision {machine['revision']}; load {machine['load_average']} at the start")


def as_shown(found):
    """The names of the columns and the rows as text."""
    return [[name.replace("_", " ") for name in HEAD],
            *([three_digits(cell) if name in SPREAD else f"{cell:,}" if isinstance(cell, int) else cell
               for name, cell in zip(HEAD, row)] for row in found)]


def text(found):
    """Columns with as many spaces as they need."""
    lines = as_shown(found)
    widths = [max(len(line[column]) for line in lines) for column in range(len(HEAD))]
    return "\n".join("  ".join(cell.rjust(width) if name in NUMBERS else cell.ljust(width)
                               for name, cell, width in zip(HEAD, line, widths)).rstrip() for line in lines)


def markdown(machine, found):
    """The same as a page, as bench/results keeps it."""
    names, *lines = ["| " + " | ".join(cells) + " |" for cells in as_shown(found)]
    published = [f"- published: {source}" for source in sources(found)]
    return "\n".join(["# All figures of speed", "", head(machine), "", names, "|---" * len(HEAD) + "|", *lines, "", *published])


def write(measured, ratios, shown, folder):
    """shown: the samples that are in the table."""
    names = [field.name for field in fields(Sample)]
    for name, lines in (("measurements.csv", [names, *map(astuple, measured)]), ("ratios.csv", [names, *map(astuple, ratios)]),
                        ("table.csv", [HEAD, *rows(shown)])):
        with open(os.path.join(folder, name), "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows(lines)
