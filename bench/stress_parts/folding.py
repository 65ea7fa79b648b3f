"""Elements that are crushed, with default settings: no corner of any turns inside out."""

import os
from dataclasses import asdict

from report_parts.builds import ROOT

from . import program, random_scenes
from .case import Row
from .judge import ACCURATE, WRONG, at_most
from .scene import block, plastic

GROUP = "folding"
SCENES_AT_RANDOM = {"full": 200, "quick": 10}
LARGEST_ENERGY_ERROR = 0.02
COPPER = plastic("copper", 400.0, 100.0, density=8.93e-3, young=117e3, poisson=0.35)  # g-mm-ms
STEEL = plastic("steel", 400.0, 500.0, density=7.85e-3, young=210e3, poisson=0.3)
ALUMINIUM = plastic("aluminium", 180.0, 250.0, density=2.7e-3, young=70e3, poisson=0.33)
FLOOR = [{"name": "floor", "normal": [0.0, 0.0, 1.0]}]
Z = [0.0, 0.0, 1.0]
QUARTER = [{"type": "symmetry", "normal": normal} for normal in ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0])]


def scene(end, materials, bodies, **more):
    """With the element that a scene gets which says nothing of it."""
    return {"title": "folding", "units": "g-mm-ms", "time": {"end": float(end)}, "material": materials, "body": bodies, **more}


def bar(mesh, speed):
    bar = {"name": "bar", "material": "copper", "mesh": mesh, "velocity": [0.0, 0.0, -float(speed)]}
    return scene(0.08, [COPPER], [bar], rigid_wall=FLOOR, **({"constraint": QUARTER} if mesh.get("section") == "quarter" else {}))


def square(across, along):
    return {"type": "block", "size": [6.4, 6.4, 32.4], "elements": [across, across, along]}


def cylinder(radius, length, core, ring, layers):
    return {"type": "cylinder", "section": "quarter", "radius": radius, "length": length, "core": core, "ring": ring, "layers": layers}


def cube_on_plate(elements, speed):
    cube = block("cube", [10.0] * 3, [elements] * 3, "steel", position=[10.0, 10.0, 5.3], velocity=[0.0, 0.0, -float(speed)])
    plate = block("plate", [30.0, 30.0, 5.0], [12, 12, 2], "steel")
    return scene(0.05, [STEEL], [cube, plate])


def pressed(height, to, speed, material, body):
    """From above, onto a floor or onto its own held foot."""
    top = {"point": [0.0, 0.0, height], "normal": Z}
    return scene((1 - to) * height / speed, [material], [body],
                 prescribed_velocity=[{"direction": Z, "speed": -float(speed), "plane": top}])


def pressed_block():
    made = pressed(60.0, 0.1, 200.0, STEEL, block("block", [20.0, 20.0, 60.0], [2, 2, 6], "steel"))
    held = {"type": "fixed", "directions": "all", "plane": {"point": [0.0, 0.0, 0.0], "normal": Z}}
    return {**made, "constraint": [held], "contact": {"method": "pinball", "self": True}}


def pressed_cylinder():
    body = {"name": "cylinder", "material": "aluminium", "mesh": cylinder(10.0, 20.0, 4, 4, 10)}
    return {**pressed(20.0, 0.1, 100.0, ALUMINIUM, body), "rigid_wall": FLOOR, "constraint": QUARTER}


def cases(form):
    """(title, scene or the name of one that comes along)"""
    found = [("a square bar of copper, 6 x 6 x 30 elements, on a wall at 227 m/s", bar(square(6, 30), 227)),
             ("a cube of steel, 4^3 elements, on a plate at 1,000 m/s", cube_on_plate(4, 1000)),
             ("a block of 2 x 2 x 6 elements, held below, pressed to a tenth at 200 m/s", pressed_block()),
             ("rod_plate", "rod_plate")]
    if form == "full":
        found += [("the square bar at 400 m/s", bar(square(6, 30), 400)),
                  ("a round bar of 480 elements at 227 m/s", bar(cylinder(3.2, 32.4, 2, 2, 40), 227)),
                  ("the round bar at 400 m/s", bar(cylinder(3.2, 32.4, 2, 2, 40), 400)),
                  ("the cube of 8^3 elements", cube_on_plate(8, 1000)),
                  ("the cube of 4^3 elements at 3,000 m/s", cube_on_plate(4, 3000)),
                  ("a cylinder of aluminium pressed to a tenth of its height", pressed_cylinder()),
                  ("crushed_tube", "crushed_tube"), ("rod_oblique", "rod_oblique")]
    return found


# rod_oblique is an example of the report, whose elements nothing keeps from folding.
DEFAULTS = ("--set", "element.hourglass=assumed_strain", "--set", "element.folding_resistance=0.02")


def figures_of(run):
    summary = run.summary
    return [at_most("elements inside out in any step", summary["inside_out"]["most"], 0),
            at_most("energy balance error", summary["energy"]["balance_error_max"], LARGEST_ENERGY_ERROR)]


def row(case, folder):
    title, made = case
    comes_along = isinstance(made, str)
    run = program.run(os.path.join(ROOT, "data/scenes", f"{made}.toml") if comes_along else made, folder, timeout=900.0,
                      arguments=DEFAULTS if comes_along else ())
    figures = figures_of(run) if run.summary else []
    right = run.status == 0 and all(figure.holds for figure in figures)
    text = "; ".join(f"{figure.name} {figure.value:.3g}" for figure in figures) or run.message
    return Row(GROUP, title, ACCURATE if right else WRONG, right, text,
               [{**asdict(figure), "holds": figure.holds} for figure in figures], run.summary.get("steps", 0), run.seconds, (ACCURATE,))


def with_default_element(seed):
    return {key: table for key, table in random_scenes.random_scene(seed).items() if key != "element"}


def row_at_random(count, folder, map_all):
    def most_of(seed):
        run = program.run(with_default_element(seed), os.path.join(folder, f"folding_{seed}"))
        return run.summary.get("inside_out", {}).get("most", 0), run.seconds

    results = list(map_all(most_of, range(count)))
    folded = [seed for seed, (most, _) in enumerate(results) if most > 0]
    figure = at_most("scenes with elements inside out", len(folded), 0)
    text = f"{count} scenes, {len(folded)} with elements inside out" + (f": seeds {folded[:20]}" if folded else "")
    return Row(GROUP, "scenes at random", WRONG if folded else ACCURATE, not folded, text, [asdict(figure)], 0,
               sum(seconds for _, seconds in results), (ACCURATE,))


def rows(form, folder, map_all=map):
    """map_all: map, or that of a pool of threads."""
    numbered = list(enumerate(cases(form)))
    found = list(map_all(lambda each: row(each[1], os.path.join(folder, f"folding_case_{each[0]}")), numbered))
    return found + [row_at_random(SCENES_AT_RANDOM[form], folder, map_all)]
