"""How many of the error bars of `pinball converge` contain what is exactly known, over the scenes that have such numbers.

An error bar is the value on the scene's own mesh with what all sources together may move it by; quantities without one
(they oscillate or diverge) are counted apart. At least nine of ten have to contain the truth, and docs/accuracy.md has to say
what is found, with the misses by name.

    error_bars_of_scenes_test.py PROGRAM FOLDER [SCENE]...
"""

import dataclasses
import json
import math
import pathlib
import subprocess
import sys

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs/accuracy.md"
LEAST_SHARE = 0.9


@dataclasses.dataclass
class Case:
    scene: str
    exact: dict[str, float]
    options: tuple[str, ...] = ()


def plate_impact():
    """Two waves in small strains; behind the second the plate rests on the wall until its end, when the first is back.
    data/reference/plate_impact_copper_exact.csv has stresses: of the middle at the end, of the wall behind both fronts."""
    area, mass, end, yield_stress, plastic_modulus = 1e-4, 8.31e-8, 10.66e-6, 20300, 1.5e5
    at_wall, at_middle = 138772.2, 20946.841
    impulse = at_wall * area * end
    return {"wall_impulse": impulse, "plate_velocity_z": impulse / mass - 1000, "middle_stress_zz": -315.20391,
            "middle_effective_stress": at_middle, "middle_plastic_strain": (at_middle - yield_stress) / plastic_modulus,
            "rigid_walls.wall.force_max": at_wall * area, "energy.external": 0}


def cantilever():
    """A Timoshenko beam of 10 x 1 x 1, E = 1, at rest under its force: work of the force, all of it elastic."""
    force, length, height, width, shear_modulus = 2.5e-7, 10.0, 1.0, 1.0, 0.5 / 1.3
    area, inertia = height * width, width * height**3 / 12
    deflection = force * length**3 / (3 * inertia) + force * length / (5 / 6 * shear_modulus * area)
    return {"tip_displacement_y": deflection, "energy.internal": force * deflection / 2, "energy.external": force * deflection / 2,
            "energy.hourglass": 0}


def sphere_wall():
    """data/reference/README.md, of a whole sphere: its largest force, and the velocity with which it leaves the wall."""
    part = math.sin(math.radians(10)) / (2 * math.pi)
    mass = 0.01 * 4 / 3 * math.pi * 5**3
    return {"rigid_walls.wall.force_max": 192.7 * part, "wall_impulse": mass * part * (2 + 1.99788), "energy.external": 0,
            "energy.hourglass": 0}


CASES = [
    # Bars that exchange their velocities, and lose nothing.
    Case("two_bars", {"energy.kinetic": 0.05, "energy.internal": 0, "energy.bulk_viscosity": 0, "energy.contact": 0,
                      "bar1_velocity_x": 0, "bar2_velocity_x": 0.1, "x5_velocity_x": 0, "x10_velocity_x": 0,
                      "x10_5_velocity_x": 0.1, "x15_5_velocity_x": 0.1, "x10_5_velocity_x:max": 0.1,
                      "x15_5_velocity_x:max": 0.1}),
    Case("newtons_cradle", {"energy.kinetic": 0.05, "energy.internal": 0, "energy.contact": 0, "bar1_velocity_x": 0,
                            "bar2_velocity_x": 0, "bar3_velocity_x": 0, "bar4_velocity_x": 0, "bar5_velocity_x": 0.1}),
    Case("plate_impact", plate_impact()),
    # Critically damped, for forty times its slowest time.
    Case("contact_patch", {"lower_velocity_z": 0, "upper_velocity_z": 0}),
    Case("cantilever", cantilever()),
    # Other programs, converged (data/scenes/taylor_bar.toml). The mesh of docs/accuracy.md, its halves and doubles.
    Case("taylor_bar", {"tail_position_z": 21.47, "rim_position_x": 7.32, "energy.external": 0},
         ("--set", "body.bar.mesh.core=4", "--set", "body.bar.mesh.ring=2", "--set", "body.bar.mesh.layers=40")),
    Case("sphere_wall", sphere_wall()),
    Case("sphere_floor", {"energy.hourglass": 0, "energy.contact": 0}),
]


@dataclasses.dataclass
class Found:
    """Of one scene: quantities by what their error bar does."""

    hits: list[str]
    misses: list[str]
    without: list[str]


def study_of(case, program, folder):
    table = folder / f"{case.scene}.json"
    of = [option for name in case.exact for option in ("--of", name)]
    subprocess.run([program, "converge", case.scene, *case.options, *of, "--quiet", "--out", folder / case.scene, "--json", table],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return json.loads(table.read_text())


def compare(case, study):
    found = Found([], [], [])
    own = [mesh["factor"] for mesh in study["meshes"]].index(study["sources_mesh"])
    for quantity in study["quantities"]:
        name, error = quantity["name"], quantity["together"]
        if error is None:
            found.without.append(name)
            continue
        value, exact = quantity["values"][own], case.exact[name]
        holds = abs(value - exact) <= error
        (found.hits if holds else found.misses).append(name)
        print(f"  {name:32} {value:14.7g} +- {error:<10.3g} {exact:14.7g}  {'' if holds else 'MISSED'}")
    return found


def row_of(scene, found):
    """As docs/accuracy.md has it."""
    lists = [", ".join(f"`{name}`" for name in names) for names in (found.hits, found.misses, found.without)]
    return f"| `{scene}` | " + " | ".join(lists) + " |"


def main():
    program, folder, *only = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    rows, hits, misses = [], 0, 0
    for case in CASES:
        if only and case.scene not in only:
            continue
        print(case.scene, flush=True)
        found = compare(case, study_of(case, program, folder))
        rows.append(row_of(case.scene, found))
        hits, misses = hits + len(found.hits), misses + len(found.misses)
    sentence = f"In {hits} of {hits + misses}"
    print("\n".join([sentence, *rows]))
    text = PAGE.read_text()
    wrong = [row for row in rows if row not in text]
    if not only and sentence not in text:
        wrong.append(sentence)
    for line in wrong:
        print(f"{PAGE}: expected {line}")
    enough = hits >= LEAST_SHARE * (hits + misses)
    if not enough and not only:
        print(f"expected error bars that hold the truth in {LEAST_SHARE:.0%}")
    return 1 if wrong or not (enough or only) else 0


if __name__ == "__main__":
    sys.exit(main())
