#!/usr/bin/env python3
"""Writes rod_plate.k and taylor_bar.k from the scenes of these names, with commas, so that coordinates keep their bits.

    PYTHONPATH=build/release/python data/decks/write_from_scenes.py build/release/pinball
"""
import pathlib
import subprocess
import sys
import tempfile

import pinball
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

FOLDER = pathlib.Path(__file__).resolve().parent
SCENES = FOLDER.parent / "scenes"


def corners_of(program, scene):
    """Places of the corners of all elements, in the order of the scene: from its first fields."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([program, "run", scene, "--out", folder, "--quiet", "--set", "time.steps=1",
                        "--set", "output.field_times=[0.0]"], check=True, stdout=subprocess.DEVNULL)
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(min(pathlib.Path(folder).glob("fields_*.vtu"))))
        reader.Update()
        return vtk_to_numpy(reader.GetOutput().GetCells().GetConnectivityArray()).reshape(-1, 8)


def mesh_text(program, scene, bodies, held):
    """Nodes and solids; held: the TC code of a point."""
    simulation = pinball.Simulation(pinball.read_scene(scene))
    points, corners = simulation.initial_position(), corners_of(program, scene)
    nodes, solids = ["*NODE"], ["*ELEMENT_SOLID"]
    for n, (x, y, z) in enumerate(points.tolist(), 1):
        code = held(x, y, z)
        nodes.append(f"{n},{x!r},{y!r},{z!r}" + (f",{code}" if code else ""))
    for part, body in enumerate(bodies, 1):
        of_body = simulation.elements_of(body)
        for e in range(of_body.start, of_body.stop):
            solids.append(",".join(str(i) for i in [e + 1, part] + [c + 1 for c in corners[e].tolist()]))
    return "\n".join(nodes + solids) + "\n"


def tangent_modulus(young, plastic):
    """Et of the slope H over the plastic strain, such that E Et/(E - Et) gives H again, to the last bit where it can."""
    guess = young * plastic / (young + plastic)
    near = [guess * (1 + k * 1e-17) for k in range(-40, 41)]
    return min(near, key=lambda et: abs(young * et / (young - et) - plastic))


def young_and_poisson(material):
    k, g = material.bulk_modulus, material.shear_modulus
    return 9 * k * g / (3 * k + g), (3 * k - 2 * g) / (2 * (3 * k + g))


def taylor_bar(program):
    code = {(False, False): 0, (True, False): 1, (False, True): 2, (True, True): 4}
    mesh = mesh_text(program, str(SCENES / "taylor_bar.toml"), ["bar"], lambda x, y, z: code[abs(x) < 1e-9, abs(y) < 1e-9])
    (FOLDER / "taylor_bar.k").write_text(f"""$ The scene taylor_bar as a deck, by write_from_scenes.py: a quarter of a copper bar strikes a rigid wall with 227 m/s.
*KEYWORD
*TITLE
Taylor bar: copper on a rigid wall, 227 m/s [g, mm, ms]
*CONTROL_TERMINATION
0.08
*CONTROL_HOURGLASS
4,0.05
*CONTROL_BULK_VISCOSITY
$ next to none: 0 stands for the default
1.0E-30,1.0E-30
*PART
bar
1,1,1
*SECTION_SOLID
1,1
*MAT_PLASTIC_KINEMATIC
$ isotropic: beta = 1
1,8.93E-3,117000.0,0.35,400.0,{tangent_modulus(117e3, 100.0)!r},1.0
0
*INITIAL_VELOCITY
0
0.0,0.0,-227.0
*RIGIDWALL_PLANAR
0
0.0,0.0,0.0,0.0,0.0,1.0,0.0
*DATABASE_GLSTAT
0.001
{mesh}*END
""")


def hardening_curve(number, yield_stress, slope, ultimate):
    strain = (ultimate - yield_stress) / slope
    return f"*DEFINE_CURVE\n{number}\n0.0,{yield_stress!r}\n{strain!r},{ultimate!r}\n10.0,{ultimate!r}\n"


def rod_plate(program):
    path = str(SCENES / "rod_plate.toml")
    scene = pinball.read_scene(path)
    mesh = mesh_text(program, path, ["rod", "plate"], lambda x, y, z: 2 if abs(y) < 1e-9 else 0)
    materials = ""
    for number, m in enumerate(scene.materials, 1):
        young, poisson = young_and_poisson(m)
        materials += f"*MAT_PIECEWISE_LINEAR_PLASTICITY_TITLE\n{m.name}\n"
        materials += f"{number},{m.density!r},{young!r},{poisson!r},{m.yield_stress!r},0.0,{m.erosion_strain!r}\n"
        materials += f"0,0,{10 + number},0,0\n0\n0\n"
        materials += hardening_curve(10 + number, m.yield_stress, m.plastic_modulus, m.ultimate_stress)
    (FOLDER / "rod_plate.k").write_text(f"""$ The scene rod_plate, penetration problem 1 of the report, as a deck, by write_from_scenes.py: half of a copper rod and of
$ a steel plate. Contact is what decks have, exact, in place of the report's penalties.
*KEYWORD
*TITLE
Copper rod strikes a steel plate at 45 degrees (report, problem 1) [lbf s2/in, in, s]
*CONTROL_TERMINATION
54.0E-6
*CONTROL_HOURGLASS
4,0.05
*CONTROL_BULK_VISCOSITY
1.44,0.06
*PART
rod
1,1,1
plate
2,1,2
*SECTION_SOLID
1,1
{materials}*INITIAL_VELOCITY_GENERATION
1,2,0.0,55566.0,0.0,-55566.0

*CONTACT_ERODING_SURFACE_TO_SURFACE
1,2,3,3
0.0,0.0
*DATABASE_GLSTAT
0.5E-6
*DATABASE_BINARY_D3PLOT
27.0E-6
{mesh}*END
""")


if __name__ == "__main__":
    taylor_bar(sys.argv[1])
    rod_plate(sys.argv[1])
