"""Plots history.csv: energies and their balance, momentum, bodies, time step."""

import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from view.history import read_history
from view.labels import time_scale, with_unit

ENERGIES = {
    "kinetic": "kinetic",
    "internal": "internal",
    "hourglass": "hourglass",
    "bulk_viscosity": "bulk viscosity",
    "contact_stored": "contact, stored",
    "contact_damped": "contact, damped",
    "eroded": "eroded",
    "external": "external work",
    "total": "total",
}
DASHES = {"x": "-", "y": ":", "z": "--"}


def plot_components(axes, time, columns, prefixes, colours, names=""):
    """Lines prefix_x, _y, _z of each prefix; components that stay negligible are left out."""
    largest = max(np.nanmax(np.abs(columns[f"{p}_{c}"]), initial=0.0) for p in prefixes for c in "xyz")
    for prefix, colour in zip(prefixes, colours):
        for component, dashes in DASHES.items():
            values = columns[f"{prefix}_{component}"]
            if np.nanmax(np.abs(values), initial=0.0) > 1e-3 * largest:
                label = f"{prefix.removesuffix('_velocity')} {component}" if names == "body" else component
                axes.plot(time, values, dashes, color=colour, label=label)


def plot_history(folder, out):
    """Draws FOLDER/history.csv as the PNG file `out`. Raises BadInput."""
    columns, units = read_history(os.path.join(folder, "history.csv"))
    factor, time_unit = time_scale(columns["time"], units.get("time", ""))
    time = columns["time"] * factor
    bodies = [name.removesuffix("_mass_remaining") for name in columns if name.endswith("_mass_remaining")]
    colours = [plt.get_cmap("tab10")(i % 10) for i in range(len(bodies))]

    figure, grid = plt.subplots(2, 3, figsize=(15, 8), sharex=True, constrained_layout=True)
    (energy, balance, step), (momentum, velocity, mass) = grid

    largest = max(np.nanmax(np.abs(columns[name]), initial=0.0) for name in ENERGIES if name in columns)
    for name, label in ENERGIES.items():
        if name not in columns or np.nanmax(np.abs(columns[name]), initial=0.0) <= 1e-9 * largest:
            continue  # a part this scene does not have
        total = name == "total"
        energy.plot(time, columns[name], color="black" if total else None, lw=2.2 if total else 1.5, label=label)
    energy.set_title("Energy")
    energy.set_ylabel(with_unit("energy", units.get("energy")))

    balance.plot(time, 100.0 * columns["balance_error"], color="tab:red")
    balance.axhline(0.0, color="grey", lw=0.8)
    balance.set_title("Error of the energy balance")
    balance.set_ylabel("(total − initial total) / initial total [%]")

    step.plot(time, columns["dt"] * factor, color="tab:purple")
    step.set_ylim(bottom=0.0)
    step.set_title("Time step")
    step.set_ylabel(with_unit("dt", time_unit))

    plot_components(momentum, time, columns, ["momentum"], ["tab:blue"])
    momentum.set_title("Momentum")
    momentum.set_ylabel(with_unit("momentum", units.get("momentum")))

    if bodies:
        plot_components(velocity, time, columns, [f"{body}_velocity" for body in bodies], colours, "body")
    velocity.set_title("Velocity of the remaining elements")
    velocity.set_ylabel(with_unit("velocity", units.get("velocity")))

    for body, colour in zip(bodies, colours):
        remaining = columns[f"{body}_mass_remaining"]
        mass.plot(time, 100.0 * remaining / (remaining[0] or 1.0), color=colour, label=body)
    mass.set_ylim(0.0, 105.0)
    mass.set_title("Mass remaining")
    mass.set_ylabel("mass / first mass [%]")

    for axes in grid.flat:
        axes.grid(alpha=0.3)
        axes.tick_params(labelbottom=True)
        axes.set_xlabel(with_unit("time", time_unit))
        if axes.get_legend_handles_labels()[0]:
            axes.legend(fontsize=9, framealpha=0.8)
    figure.savefig(out, dpi=110)
    plt.close(figure)
