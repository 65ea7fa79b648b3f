"""What docs/extending.md adds does what it says: each is run once in a program that has all of it, and held to a closed form.
Part of extending_test.py."""

import csv
import json
import math
import os
import subprocess
import sys

CUBE = """
units = "g-mm-ms"
[time]
end = {end}
cfl = 0.5
[element]
bulk_viscosity = false
hourglass = "none"
[guard]
energy_error = 1e30
[output]
interval = {interval}
[[material]]
name = "stuff"
model = "von_mises"
density = 0.00785
{material}
[[body]]
name = "cube"
material = "stuff"
mesh = {{ type = "block", size = [1, 1, 1], elements = [1, 1, 1] }}
[[constraint]]
type = "fixed"
directions = ["x"]
plane = {{ point = [0, 0, 0], normal = [1, 0, 0] }}
[[constraint]]
type = "fixed"
directions = ["y", "z"]
{held}
[[prescribed_velocity]]
plane = {{ point = [1, 0, 0], normal = [1, 0, 0] }}
direction = [1, 0, 0]
speed = {speed}
[[probe]]
name = "inside"
kind = "element"
point = [0.5, 0.5, 0.5]
[[probe]]
name = "end"
point = [1, 1, 1]
"""
EDGE = "line = { point = [0, 0, 0], direction = [1, 0, 0] }"
STEEL = "bulk_modulus = 160000\nshear_modulus = 80000\nyield_stress = 400\n"


def call(program, *words):
    return subprocess.run([program, *map(str, words)], capture_output=True, text=True,
                          env={**os.environ, "GOMP_SPINCOUNT": "1000"})


def run(program, scene, out, *words):
    """summary.json and the rows of history.csv."""
    done = call(program, "run", scene, "--quiet", "--threads", 1, "--out", out, *words)
    assert done.returncode == 0, done.stderr
    with open(out / "history.csv", encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return json.loads((out / "summary.json").read_text()), [{key: float(value) for key, value in row.items()} for row in rows]


def pull(program, folder, name, **given):
    """A cube that is pulled along x."""
    scene = folder / f"{name}.toml"
    scene.write_text(CUBE.format(**{"end": 0.2, "interval": 1e-9, "held": EDGE, "speed": 1.0, **given}))
    return run(program, scene, folder / name)[1]


def check_the_key(program, folder):
    """time.largest_step is a key as any other."""
    assert "time.largest_step" in call(program, "schema", "--keys").stdout.split()
    wrong = call(program, "info", "two_blocks", "--set", "time.largest_step=-1")
    assert wrong.returncode == 2 and "--set time.largest_step=-1: expected a number >= 0, got -1" in wrong.stderr, wrong.stderr
    few, _ = run(program, "two_blocks", folder / "few")
    assert "time.largest_step" in (folder / "few" / "index.html").read_text()
    many, _ = run(program, "two_blocks", folder / "many", "--set", f"time.largest_step={few['dt']['max'] / 4}")
    assert many["steps"] > 3 * few["steps"], (few["steps"], many["steps"])


def check_the_page(program, tree):
    """Keys, tables and a format are on the page of scenes."""
    subprocess.run([sys.executable, "docs/scene-keys", "--fix", "--program", program], cwd=tree, check=True)
    page = (tree / "data/scenes/README.md").read_text()
    for row in ("| `largest_step` | number >= 0 | T | `0.0` | no step is longer; 0: as long as is stable |",
                "| `saturation` | number > 0 | M/(L T^2) | required | Q |", '| `type` | `"medit"` |  | required | what it is |'):
        assert row in page, row


def check_the_yield_law(program, folder):
    """The effective stress is that of Voce at each plastic strain."""
    rows = pull(program, folder, "voce", material=STEEL + "voce = { saturation = 200, rate = 30 }")
    strained = [row for row in rows if row["inside_plastic_strain"] > 1e-3]
    assert len(strained) > 1000 and strained[-1]["inside_plastic_strain"] > 0.1, len(strained)
    for row in strained:
        expected = 400 + 200 * (1 - math.exp(-30 * row["inside_plastic_strain"]))
        assert abs(row["inside_effective_stress"] / expected - 1) < 1e-9, row
    wrong = call(program, "info", folder / "voce.toml", "--set", "material.stuff.plastic_modulus=1")
    assert wrong.returncode == 2 and "expected none beside voce" in wrong.stderr, wrong.stderr


def check_the_equation_of_state(program, folder):
    """Squeezed to half its volume, with its sides held, the pressure is that of Murnaghan."""
    material = ("shear_modulus = 100\nyield_stress = 10\n"
                "equation_of_state = { form = \"murnaghan\", bulk_modulus = 2200, exponent = 7 }")
    rows = pull(program, folder, "murnaghan", material=material, speed=-2.5, held="body = \"cube\"")
    for row in rows:
        expected = 2200 / 7 * ((1 + row["end_displacement_x"]) ** -7 - 1)
        pressure = -(row["inside_stress_xx"] + row["inside_stress_yy"] + row["inside_stress_zz"]) / 3
        assert abs(pressure - expected) <= 1e-9 * max(expected, 2200), (row["time"], pressure, expected)
    assert rows[-1]["end_displacement_x"] < -0.49, rows[-1]


def check_the_failure_and_the_column(program, folder):
    """Of a cube that yields at 400, the work of Cockcroft and Latham is 400 times its plastic strain, but for waves."""
    for work in (20, 40):
        rows = pull(program, folder, f"tension_{work}", material=STEEL + f"erosion = {{ tensile_work = {work} }}")
        living = [row for row in rows if row["living_elements"] == 1]
        assert 0 < len(living) < len(rows) and all(row["living_elements"] == 0 for row in rows[len(living):]), len(living)
        strains = [row["inside_plastic_strain"] for row in living]
        done = sum(max(0, row["inside_stress_xx"]) * (now - before) for row, before, now in zip(living[1:], strains, strains[1:]))
        assert work - 2 * 400 * (strains[-1] - strains[-2]) < done <= work, (work, done)
        assert abs(strains[-1] / (work / 400) - 1) < 0.02, (work, strains[-1])
    rows = pull(program, folder, "pressed", speed=-1, material=STEEL + "erosion = { tensile_work = 20 }")
    assert rows[-1]["living_elements"] == 1 and rows[-1]["inside_plastic_strain"] > 0.1, rows[-1]
    # What is kept of an element goes on from a checkpoint.
    words = [folder / "tension_40.toml", "--quiet", "--threads", 1]
    part = call(program, "run", *words, "--out", folder / "part", "--checkpoint-every", 400, "--set", "time.steps=1000")
    rest = call(program, "run", "--restart", folder / "part" / "checkpoint.pinball", "--quiet", "--threads", 1, "--out",
                folder / "rest", "--set", "time.steps=-1")
    assert part.returncode == rest.returncode == 0, part.stderr + rest.stderr
    states = [json.loads((folder / name / "summary.json").read_text())["state_hash"] for name in ("tension_40", "rest")]
    assert states[0] == states[1], states
    elastic = call(program, "info", folder / "pressed.toml", "--set", "material.stuff.model=elastic")
    assert elastic.returncode == 2 and "tensile_work" in elastic.stderr, elastic.stderr


DECK = """*KEYWORD
*CONTROL_TERMINATION
{end},0
*CONTROL_TIMESTEP
0,0.02
*CONTROL_BULK_VISCOSITY
0,1e-12
*DATABASE_GLSTAT
{interval},0
*PART
cube
1,1,1
*SECTION_SOLID
1
*MAT_ELASTIC
1,7.85e-3,200000.,0.3
*NODE
1,0.,0.,0.
2,1.,0.,0.
3,1.,1.,0.
4,0.,1.,0.
5,0.,0.,1.
6,1.,0.,1.
7,1.,1.,1.
8,0.,1.,1.
*ELEMENT_SOLID
1,1,1,2,3,4,5,6,7,8
*CONSTRAINED_GLOBAL
3,0,3,0.,0.,0.
1,0,1,0.,0.,0.
1,0,1,1.,0.,0.
2,0,2,0.,0.,0.
2,0,2,0.,1.,0.
*DEFINE_CURVE
1
0.,1.
1.,1.
*LOAD_BODY_Z
1,{gravity}
*DATABASE_HISTORY_NODE
7
*END
"""


def check_the_card(program, folder):
    """A cube between planes that weighs on its base sinks to twice rho g L^2/(2 M), as a mass that a spring catches."""
    density, gravity, modulus = 7.85e-3, 1e4, 200000 * (1 - 0.3) / ((1 + 0.3) * (1 - 2 * 0.3))
    period = 2 * math.pi * math.sqrt(density / 2 / modulus)
    deck = folder / "planes.k"
    deck.write_text(DECK.format(end=1.25 * period, interval=period / 1000, gravity=gravity))
    _, rows = run(program, deck, folder / "planes")
    deepest = min(row["node_7_displacement_z"] for row in rows)
    assert abs(deepest / (-density * gravity / modulus) - 1) < 0.002, (deepest, -density * gravity / modulus)
    assert max(abs(row["node_7_displacement_x"]) + abs(row["node_7_displacement_y"]) for row in rows) == 0
    deck.write_text(DECK.format(end=1, interval=1, gravity=1).replace("3,0,3,0.,0.,0.", "3,0,4,0.,0.,0."))
    wrong = call(program, "info", deck)
    assert wrong.returncode == 2 and "planes.k:" in wrong.stderr and "DIR" in wrong.stderr, wrong.stderr


MEDIT = """MeshVersionFormatted 2
# a hexahedron, a prism behind it, a pyramid above and a tetrahedron above that
Dimension 3
Vertices 12
0 0 0 1
1 0 0 1
1 1 0 1
0 1 0 1
0 0 1 1
1 0 1 1
1 1 1 1
0 1 1 1
2 0 0 1
2 0 1 1
0.5 0.5 2 1
0.5 -0.5 2 1
Hexahedra 1
1 2 3 4 5 6 7 8 10
Prisms 1
2 9 3 6 10 7 20
Pyramids 1
5 6 7 8 11 30
Tetrahedra
1
5 12 6 11 40
Edges 1
1 2 7
Quadrilaterals 1
1 4 3 2 5
End
"""
BODY = """
[[body]]
name = "body_{part}"
material = "stuff"
mesh = {{ type = "file", file = "{file}", part = "{part}" }}
"""
FILES = """
units = "kg-m-s"
[time]
end = 1
steps = 1
[[material]]
name = "stuff"
model = "elastic"
density = 1000
bulk_modulus = 1e9
shear_modulus = 1e9
"""


def check_the_format(program, folder):
    """The parts of a file of Medit have the volumes of their shapes; its quadrilateral is a set of faces."""
    (folder / "shapes.mesh").write_text(MEDIT)
    volumes = {10: 1, 20: 1 / 2, 30: 1 / 3, 40: 1 / 6}
    pressed = '[[pressure]]\nset = "5"\nfile = "shapes.mesh"\npressure = 1\n'
    scene = folder / "shapes.toml"
    scene.write_text(FILES + "".join(BODY.format(part=part, file="shapes.mesh") for part in volumes) + pressed)
    summary, _ = run(program, scene, folder / "shapes")
    assert summary["elements"] == 4 and summary["nodes"] == 12, summary
    for body in summary["bodies"]:
        volume = volumes[int(body["name"].split("_")[1])]
        assert abs(body["mass_initial"] / (1000 * volume) - 1) < 1e-12, body
    for wrong, message in ((MEDIT.replace("5 6 7 8 11 30", "5 6 7 8 13 30"), "expected a vertex from 1 to 12, got \"13\""),
                           (MEDIT[:MEDIT.index("Pyramids")] + "Pyramids 1\n5 6", "expected as many lines that the rest of the file can hold")):
        (folder / "wrong.mesh").write_text(wrong)
        told = call(program, "info", folder / "wrong.mesh")
        assert told.returncode == 2 and "wrong.mesh:" in told.stderr and message in told.stderr, told.stderr


CORNERS = [(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]

CENTRES = [(0.5, 0.5, 0), (0.5, 0.5, 1), (0.5, 0, 0.5), (1, 0.5, 0.5), (0.5, 1, 0.5), (0, 0.5, 0.5), (0.5, 0.5, 0.5)]


def middle(a, b):
    return tuple((p + q) / 2 for p, q in zip(CORNERS[a], CORNERS[b]))


def lines(rows):
    return "".join(" ".join(map(str, row)) + "\n" for row in rows)


def check_the_element(program, folder):
    """A hexahedron of 27 nodes is that of its corners, in each format that has it."""
    nodes = [tuple(2 * x for x in node) for node in CORNERS + [middle(a, b) for a, b in EDGES] + CENTRES]
    numbers = range(1, 28)
    vtk = (f"# vtk DataFile Version 3.0\ncube\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 27 double\n{lines(nodes)}CELLS 1 28\n27 "
           + lines([range(27)]) + "CELL_TYPES 1\n29\n")
    gmsh = ("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n27\n" + lines([n, *node] for n, node in zip(numbers, nodes))
            + "$EndNodes\n$Elements\n1\n1 12 2 1 1 " + lines([numbers]) + "$EndElements\n")
    abaqus = ("*NODE\n" + lines([n, *node] for n, node in zip(numbers, nodes)).replace(" ", ", ") + "*ELEMENT, TYPE=C3D27R\n"
              + "1, " + ", ".join(map(str, range(1, 16))) + ",\n" + ", ".join(map(str, range(16, 28))) + "\n")
    for name, text in (("cube.vtk", vtk), ("cube.msh", gmsh), ("cube.inp", abaqus)):
        (folder / name).write_text(text)
        scene = folder / "many_nodes.toml"
        kind = 'type = "gmsh"' if name == "cube.msh" else 'type = "file"'
        scene.write_text(FILES + f'[[body]]\nname = "cube"\nmaterial = "stuff"\nmesh = {{ {kind}, file = "{name}" }}\n')
        summary, _ = run(program, scene, folder / f"{name}.out")
        assert (summary["elements"], summary["nodes"]) == (1, 8), (name, summary)
        assert abs(summary["bodies"][0]["mass_initial"] / 8000 - 1) < 1e-12, (name, summary)
        told = call(program, "info", scene)
        assert "27-node hexahedra, by their corners" in told.stdout + told.stderr, (name, told.stdout, told.stderr)


def check_all(program, tree):
    folder = tree / "checks"
    folder.mkdir()
    check_the_key(program, folder)
    check_the_yield_law(program, folder)
    check_the_equation_of_state(program, folder)
    check_the_failure_and_the_column(program, folder)
    check_the_card(program, folder)
    check_the_format(program, folder)
    check_the_element(program, folder)
    check_the_page(program, tree)
