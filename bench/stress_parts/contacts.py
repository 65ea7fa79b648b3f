"""Contact where it is hard: stiffness, overlap, thin and small bodies, very fast ones, bodies that erode away."""

import math

from .case import EITHER, Case
from .judge import ACCURATE, REFUSES, STOPS, WARNS, Figure, at_most
from .scene import block, elastic, plastic, scene

METHODS = {
    "pinball, penalty": {"method": "pinball", "enforcement": "penalty"},
    "pinball, projection": {"method": "pinball", "enforcement": "projection"},
    "pinball, lagrange": {"method": "pinball", "enforcement": "lagrange"},
    "slideline, penalty": {"method": "slideline", "enforcement": "penalty"},
    "slideline, lagrange": {"method": "slideline", "enforcement": "lagrange"},
}
PINBALLS = {name: contact for name, contact in METHODS.items() if contact["method"] == "pinball"}


def along_z(run, body):
    return next(b for b in run.summary["bodies"] if b["name"] == body)["velocity"][2]


def went_through(run, speed):
    """By how much the upper body still approaches the lower one at the end, as a part of the speed of approach."""
    return [at_most("speed at which the bodies still approach / initial", max(0.0, along_z(run, "lower") - along_z(run, "upper")) / speed,
                    0.02)]


def head_on(contact, n=2, gap=0.3, speed=1e-2, end=40, materials=None, shift=(0, 0), **more):
    """Two blocks of n x n x n cubes, `gap` apart along z, each with `speed` towards the other."""
    materials = materials or [elastic()]
    return scene(end, materials, [
        block("lower", [n] * 3, [n] * 3, materials[0]["name"], velocity=[0, 0, speed]),
        block("upper", [n] * 3, [n] * 3, materials[-1]["name"], position=[*map(float, shift), n + gap], velocity=[0, 0, -speed])],
        contact=contact, **more)


def penalty_factors():
    """Two equal blocks part with about 3/4 of their speed (0.73 with Lagrange multipliers; the rest is vibration)."""
    def figures(run):
        return [Figure("rebound / speed", along_z(run, "upper") / 1e-2, 0.75, 0.1)]

    return [Case("penalty factor", f"1e{power}, {method}", head_on({"method": method, "enforcement": "penalty", "beta": 10.0**power}),
                 (ACCURATE,) if method == "pinball" and power in (-1, 0) else (ACCURATE, WARNS, STOPS), figures)
            for method in ("pinball", "slideline") for power in range(-5, 6)]


def bars(lower, upper, contact, length, speed=1e-3, waves=2.6):
    """A bar (upper) strikes one at rest, 1 x 1 x `length` elements each, without lateral strain. `waves`: passages of a wave
    through the upper one."""
    materials = [{**lower, "name": "lower"}, {**upper, "name": "upper"}]
    passage = length * math.sqrt(upper["density"] / upper["young_modulus"])
    gap = 0.2408  # at which the balls of two cubes touch; faces touch a little later
    return scene(waves * passage + (gap if contact.get("gap") == "face" else 0) / speed, materials, [
        block("lower", [1, 1, length], [1, 1, length], "lower"),
        block("upper", [1, 1, length], [1, 1, length], "upper", position=[0, 0, length + gap], velocity=[0, 0, -speed])],
        contact=contact)


def unequal_bodies():
    """Exact in one dimension. A heavy or a stiff bar is a rigid body to the other in the time of its wave; of equal
    mass it takes 1 - exp(-2) = 0.865 of the speed until the wave is back, and a far heavier one reflects all of it."""
    equal_mass = 1 - math.exp(-2)
    found = []
    for name, contact in {"pinball, penalty": {"method": "pinball", "enforcement": "penalty"},
                          "pinball, lagrange, gap of balls": {"method": "pinball", "enforcement": "lagrange", "gap": "pinball"}}.items():
        for title, lower, upper, reference in (
                ("density x 1e6: the light bar is thrown back", elastic(density=1e6, poisson=0.0), elastic(poisson=0.0), 1.0),
                ("stiffness x 1e6: the soft bar on a stiff one", elastic(young=1e6, poisson=0.0), elastic(poisson=0.0),
                 -(1 - equal_mass)),
                ("both x 1e6", elastic(density=1e6, young=1e6, poisson=0.0), elastic(poisson=0.0), 1.0)):
            def figures(run, reference=reference):
                # The front is spread over a few elements, and vibrations remain.
                return [Figure("velocity after / speed", along_z(run, "upper") / 1e-3, reference, 0.1)]
            # A stiff body that is heavy too does not shorten the step, and is a penalty factor of 1e6 to the light one.
            expected = (ACCURATE, WARNS, STOPS) if title.startswith("both") else (ACCURATE,)
            length = 10 if title.startswith("stiffness") else 20  # that takes a thousand times the steps
            found.append(Case("unequal bodies", f"{title}, {name}", bars(lower, upper, contact, length), expected, figures,
                              slow=title.startswith("stiffness")))
    return found


def overlaps():
    allowed = (ACCURATE, WARNS, STOPS, REFUSES)
    group = "overlap at the start"

    def apart(run):
        return went_through(run, 2e-2)

    found = [Case(group, f"{depth} h deep, {name}", head_on(contact, gap=-depth), allowed, apart)
             for name, contact in METHODS.items() for depth in (0.1, 0.5, 1, 1.5)]
    found += [Case(group, f"the same place (coincident pinballs), {name}", head_on(contact, gap=-2.0), allowed, apart)
              for name, contact in METHODS.items()]
    found += [Case(group, f"beside each other by half an element in x and y (parallel normals), {name}",
                   head_on(contact, gap=-2.0, shift=(0.5, 0.5)), allowed) for name, contact in METHODS.items()]
    return found


def small_bodies():
    """Exactly opposed normals, and bodies of one element."""
    found = []
    for name, contact in METHODS.items():
        # A contact of so few nodes and steps has a coarse balance with a penalty.
        expected = (ACCURATE, WARNS) if "penalty" in name else (ACCURATE,)
        found.append(Case("small bodies", f"two cubes of one element face to face, {name}", head_on(contact, n=1), expected,
                          lambda run: went_through(run, 2e-2)))
        corner = head_on(contact, n=1, gap=1.0, end=150)
        corner["body"][1]["axis"] = [1.0, 1.0, 1.0]
        found.append(Case("small bodies", f"a corner of one cube on the face of another, {name}", corner, expected))
        edge = head_on(contact, n=1, shift=(1.0, 0.0))
        found.append(Case("small bodies", f"two cubes edge to edge, {name}", edge, expected))
    return found


FALL = 5e-3


def plate(thickness, contact):
    """A block of cubes falls on a plate of one layer, in the middle of it."""
    return scene(1.2 / FALL, [elastic()], [
        block("lower", [5, 5, thickness], [5, 5, 1]),
        block("upper", [2, 2, 2], [2, 2, 2], position=[1.5, 1.5, thickness + 0.6], velocity=[0, 0, -FALL])], contact=contact)


def thin_bodies():
    """A plate thinner than the balls of its elements (radius 0.62 (h h t)^(1/3), which is more than t/2)."""
    return [Case("thin bodies", f"a plate of thickness {thickness} h under a block, {name}", plate(thickness, contact),
                 (ACCURATE, WARNS, STOPS), lambda run: went_through(run, FALL), slow=thickness < 0.1)
            for name, contact in METHODS.items() for thickness in (0.5, 0.1, 0.02)]


def fast_impacts():
    """Relative speeds of 0.1 to 10 times the wave speed: what an elastic body cannot bear stops the run."""
    found = []
    for name, contact in METHODS.items():
        for speed in (0.1, 1.0, 10.0):
            gap = 3.3
            for kind, material in (("elastic", elastic()),
                                   ("plastic, eroding", plastic(yield_stress=1e-2, plastic_modulus=1e-2, erosion_strain=1.0))):
                made = head_on(contact, n=4, gap=gap, speed=speed / 2, end=(gap + 40) / speed, materials=[material])

                def figures(run, speed=speed):
                    return went_through(run, speed) if all(b["mass_remaining"] > 0 for b in run.summary["bodies"]) else []
                found.append(Case("fast impact", f"{speed:g} x the wave speed, {kind}, {name}", made, (ACCURATE, WARNS, STOPS), figures))
    return found


def erosion():
    """Bodies that erode away altogether: their nodes fly on and keep the momentum."""
    frail = plastic("frail", yield_stress=1e-6, erosion_strain=1e-5)
    found = []
    for name, contact in METHODS.items():
        for title, materials, gone in (("one of two bodies", [elastic(), frail], {"upper"}), ("both bodies", [frail], {"lower", "upper"})):
            def figures(run, gone=gone):
                return [at_most(f"elements left of {body['name']}", body["elements"] - body["eroded_elements"], 0)
                        for body in run.summary["bodies"] if body["name"] in gone]
            found.append(Case("total erosion", f"{title}, {name}", head_on(contact, materials=materials, speed=0.1, end=20),
                              (ACCURATE, WARNS, STOPS), figures))
    wall = scene(40, [frail], [block("body", [2] * 3, [2] * 3, "frail", position=[0, 0, 0.5], velocity=[0, 0, -0.1])],
                 rigid_wall=[{"normal": [0, 0, 1]}])
    found.append(Case("total erosion", "a body on a rigid wall", wall, EITHER))
    return found


def cases(form):
    return [case for case in (penalty_factors() + unequal_bodies() + overlaps() + small_bodies() + thin_bodies() + fast_impacts()
                              + erosion()) if form == "full" or not case.slow]
