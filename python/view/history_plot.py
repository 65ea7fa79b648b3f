"""Plots history.csv: energies and their balance, momentum, bodies, time step."""

import os

import matplotlib
import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from view.history import read_history
from view.labels import time_scale, with_unit

ENERGIES = {
    "kinetic": "kinetic",
    "internal": "internal",
    "hourglass": "hourglass",
    "bulk_viscosity": "bulk viscosity",
    "folding": "folding",
    "contact_stored": "contact, stored",
    "contact_damped": "contact, damped",
    "eroded": "eroded",
    "external": "external work",
    "total": "total",
}
DASHES = {"x": "-", "y": ":", "z": "--"}


def largest_of(columns, names):
    """The largest size of the finite values of some columns."""
    values = np.concatenate([columns[name] for name in names] or [np.zeros(0)])
    return np.abs(values[np.isfinite(values)]).max(initial=0.0)


def plot_components(axes, time, columns, prefixes, colours, least, names=""):
    """Lines prefix_x, _y, _z of each prefix; components that stay negligible are left out. What is smaller than `least` is
    round-off, and said to be."""
    largest = largest_of(columns, [f"{p}_{c}" for p in prefixes for c in "xyz"])
    if largest <= least:
        axes.set_ylim(-1.0, 1.0)
        axes.axhline(0.0, color="grey", lw=0.8)
        axes.text(0.5, 0.6, "zero" if largest == 0.0 else "zero but for round-off", ha="center", transform=axes.transAxes)
        return
    for prefix, colour in zip(prefixes, colours):
        for component, dashes in DASHES.items():
            values = columns[f"{prefix}_{component}"]
            if largest_of(columns, [f"{prefix}_{component}"]) > 1e-3 * largest:
                label = f"{prefix.removesuffix('_velocity')} {component}" if names == "body" else component
                axes.plot(time, values, dashes, color=colour, label=label)


def plot_history(folder, out):
    """Draws FOLDER/history.csv as the PNG file `out`. Raises BadInput."""
    columns, units = read_history(os.path.join(folder, "history.csv"))
    factor, time_unit = time_scale(columns["time"], units.get("time", ""))
    time = columns["time"] * factor
    bodies = [name.removesuffix("_mass_remaining") for name in columns if name.endswith("_mass_remaining")]
    colours = [matplotlib.colormaps["tab10"](i % 10) for i in range(len(bodies))]
    mass_of_all = sum(columns[f"{body}_mass_remaining"][0] for body in bodies)
    # What all of it would move with if it had the largest kinetic energy: the least of that is no motion.
    fastest = np.sqrt(2.0 * largest_of(columns, ["kinetic"]) / mass_of_all) if mass_of_all > 0.0 else 0.0

    figure = Figure(figsize=(15, 8))
    FigureCanvasAgg(figure)
    grid = figure.subplots(2, 3, sharex=True)
    figure.subplots_adjust(left=0.06, right=0.985, bottom=0.07, top=0.95, wspace=0.24, hspace=0.24)
    (energy, balance, step), (momentum, velocity, mass) = grid

    largest = largest_of(columns, [name for name in ENERGIES if name in columns])
    for name, label in ENERGIES.items():
        if name not in columns or largest_of(columns, [name]) <= 1e-9 * largest:
            continue  # a part this scene does not have
        total = name == "total"
        energy.plot(time, columns[name], color="black" if total else None, lw=2.2 if total else 1.5, label=label)
    energy.set_title("Energy", y=1.0)
    energy.set_ylabel(with_unit("energy", units.get("energy")))

    balance.plot(time, 100.0 * columns["balance_error"], color="tab:red")
    balance.axhline(0.0, color="grey", lw=0.8)
    balance.set_title("Error of the energy balance", y=1.0)
    balance.set_ylabel("(total − initial total) / initial total [%]")

    step.plot(time, columns["dt"] * factor, color="tab:purple")
    # A step that is constant but for round-off would lie on the upper edge: an axis follows its values from the smallest on.
    longest = largest_of(columns, ["dt"]) * factor
    step.set_ylim(0.0 if longest > 0.0 else -1.0, 1.1 * longest or 1.0)
    step.set_title("Time step", y=1.0)
    step.set_ylabel(with_unit("dt", time_unit))

    plot_components(momentum, time, columns, ["momentum"], ["tab:blue"], 1e-10 * mass_of_all * fastest)
    momentum.set_title("Momentum", y=1.0)
    momentum.set_ylabel(with_unit("momentum", units.get("momentum")))

    if bodies:
        plot_components(velocity, time, columns, [f"{body}_velocity" for body in bodies], colours, 1e-10 * fastest, "body")
    velocity.set_title("Velocity of the remaining elements", y=1.0)
    velocity.set_ylabel(with_unit("velocity", units.get("velocity")))

    for body, colour in zip(bodies, colours):
        remaining = columns[f"{body}_mass_remaining"]
        mass.plot(time, 100.0 * remaining / (remaining[0] or 1.0), color=colour, label=body)
    mass.set_ylim(0.0, 105.0)
    mass.set_title("Mass remaining", y=1.0)
    mass.set_ylabel("mass / first mass [%]")

    for axes in grid.flat:
        axes.grid(alpha=0.3)
        axes.tick_params(labelbottom=True)
        axes.set_xlabel(with_unit("time", time_unit))
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=9, framealpha=0.8)
    figure.savefig(out, dpi=110)
