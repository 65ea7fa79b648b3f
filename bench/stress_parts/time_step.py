"""Fractions of the stable time step, and very many steps."""

import math

import numpy as np

from .case import EITHER, Case
from .judge import STOPS, Figure, at_most
from .scene import block, elastic, scene

STABLE = (0.5, 0.6, 0.7, 0.8, 0.9, 0.95)
ABOVE = (1.01, 1.05, 1.1, 1.2)
STEPS = {"full": 1_000_000, "quick": 20_000}
BODIES = {"a cube of one element": [1, 1, 1], "a bar of 1 x 1 x 10": [1, 1, 10]}


def vibrating(elements, cfl, steps):
    """A free body in all its modes, at strains of about 1e-3."""
    return scene(1e9, [elastic()], [block("body", elements, elements, velocity_noise=1e-3)], cfl=cfl, steps=steps,
                 output={"interval": steps / 500})


def energy_is_bounded(run):
    """Of the total energy at the times of the forces. It is not constant: central differences keep an energy that differs
    from it by the square of (step x frequency), 0.9 % of all for the bar at 0.9 of the stable step."""
    total = run.history["total"]
    return [at_most("largest change of the total energy", float(np.abs(total / total[0] - 1).max()), 0.02),
            at_most("kinetic energy above the initial total", max(0.0, float(run.history["kinetic"].max() / total[0] - 1)), 0.02)]


LAYERS, SPEED = 10, 1e-6


def resonating_bar(steps):
    """A free bar in its first mode, v = V cos(pi z / L), which linear elements with lumped masses keep exactly."""
    layers = [{"velocity": [0, 0, SPEED * math.cos(math.pi * n / LAYERS)], "box": {"low": [-1, -1, n - 0.1], "high": [2, 2, n + 0.1]}}
              for n in range(LAYERS + 1)]
    return scene(1e9, [elastic(poisson=0.0)], [block("bar", [1, 1, LAYERS], [1, 1, LAYERS])], steps=steps, initial_velocity=layers,
                 output={"interval": steps / 500})


def phase_is_exact(run):
    """w is that of central differences, sin(w dt / 2) = (dt c / h) sin(pi / 2N), and the kinetic energy the product of the
    velocities half a step before and after: K / K0 = (cos^2(w t) - sin^2(w dt / 2)) / cos^2(w dt / 2)."""
    dt = run.summary["dt"]["max"]
    half = math.asin(dt * math.sin(math.pi / (2 * LAYERS)))  # w dt / 2
    h = run.history
    kinetic, time = (h["kinetic"] + h["kinetic_below_zero"])[:-1], h["time"][:-1]  # the last one is of the end, after half a step
    exact = (np.cos(2 * half / dt * time)**2 - math.sin(half)**2) / math.cos(half)**2
    error = np.abs(kinetic / kinetic[0] - exact)
    return [at_most("largest error of the kinetic energy of the mode", float(error.max()), 0.01)]


def cases(form):
    steps = STEPS[form]
    found = [Case("time step", f"{fraction} of the stable step, {name}, {steps:,} steps", vibrating(elements, fraction, steps),
                  figures=energy_is_bounded, timeout=900) for fraction in STABLE for name, elements in BODIES.items()]
    found.append(Case("time step", "1.0 of the stable step, a cube of one element", vibrating([1, 1, 1], 1.0, 10_000), EITHER))
    found += [Case("time step", f"{fraction} of the stable step, a cube of one element", vibrating([1, 1, 1], fraction, 10_000),
                   (STOPS,), named=r"element \d+ of body", most_steps=300) for fraction in ABOVE]
    found.append(Case("time step", f"a bar in its first mode, {steps:,} steps", resonating_bar(steps), figures=phase_is_exact, timeout=900))
    return found


def ends_at(turns):
    """cos^2 of the phase after so many turns, where it changes nearly fastest."""
    return math.cos(2 * math.pi * turns)**2


TURNS = 1.0625


def breathing(title, group, material, size, gradient, frequency, cfl, elements=(1, 1, 1), tolerance=0.01):
    """One element that vibrates in one linear mode of known circular frequency: K = K0 cos^2(w t)."""
    amplitude = 1e-6 * frequency
    body = block("body", size, elements, velocity_gradient=[[amplitude * float(g) for g in row] for row in gradient])
    made = scene(TURNS * 2 * math.pi / frequency, [material], [body], cfl=cfl)

    def figures(run):
        return [Figure("kinetic energy after 17/16 periods / initial", run.summary["energy"]["kinetic"] / run.history["kinetic"][0],
                       ends_at(TURNS), tolerance)]

    return Case(group, title, made, figures=figures)
