"""Types of the Python package: the stub of its compiled part is what the module says, every member has a text, and mypy
takes the package and what is right in a user's program, and finds each line that is wrong. PYTHONPATH names the package's folder."""

import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PACKAGE = pathlib.Path(os.environ["PYTHONPATH"].split(os.pathsep)[0]) / "pinball"

RIGHT = '''\
import pinball

scene = pinball.read_scene("rod_plate", set=["time.steps=10"])
scene.contact.method = "pinball"
scene.contact.method = pinball.ContactMethod.pinball
scene.materials.append(pinball.Material(name="steel", density=7850, bulk_modulus=1.7e11, shear_modulus=8e10))
scene.bodies = [pinball.Body(name="b", material="steel", mesh=pinball.BlockMesh(size=[1, 1, 1], elements=(2, 2, 2)))]
for body in scene.bodies:
    body.velocity = (0.0, 0.0, -1.0)
first: pinball.Body = scene.bodies[0]
method: pinball.ContactMethod = scene.contact.method
simulation = pinball.Simulation(scene, threads=1)
simulation.on_step(lambda each: each.time < 1.0)
more: bool = simulation.run()
height = simulation.positions[:, 2].max()
energy: float = simulation.energies.kinetic + simulation.history_row().energy.total
steps: int = pinball.run_recorded(scene, "out")["steps"]
last = float(pinball.read_history("out")["time"][-1])
with_band = pinball.converge("two_bars", of=["energy.kinetic"]).value("energy.kinetic")
'''
WRONG = '''\
import pinball
scene = pinball.read_scene("rod_plate")
scene.contact.methd = "pinball"
scene.contact.beta = "much"
scene.contact.method = 3.5
scene.materials.append(pinball.Body(name="steel"))
scene.bodies[0].velocity = "fast"
pinball.Material(nme="steel")
pinball.Body(velocity=3.0)
pinball.Simulation("rod_plate")
pinball.Simulation(scene).energies.kinetic = 3.0
pinball.Simulation(scene).run_until("the end")
pinball.Simulation(scene).dt + "s"
pinball.read_scene("rod_plate", sets=["time.steps=10"])
pinball.run("rod_plate")
pinball.converge("two_bars", off=["energy.kinetic"])
'''


def mypy(folder, *names):
    return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--config-file", str(ROOT / "pyproject.toml"), "--cache-dir",
                           str(folder / "cache"), *names], cwd=folder, capture_output=True, text=True, env={**os.environ, "MYPYPATH": str(folder)})


class Stub(unittest.TestCase):
    def test_is_what_the_module_says(self):
        made = subprocess.run([sys.executable, ROOT / "python" / "stubs"], capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)

    def test_of_the_build_is_that_of_the_tree(self):
        self.assertEqual((PACKAGE / "_core.pyi").read_text(), (ROOT / "python" / "pinball" / "_core.pyi").read_text())


@unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
class Mypy(unittest.TestCase):
    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.folder = pathlib.Path(made.name)
        shutil.copytree(PACKAGE, self.folder / "pinball", ignore=shutil.ignore_patterns("*.so", "__pycache__"))

    def test_takes_the_package(self):
        found = mypy(self.folder, "pinball")
        self.assertEqual(found.returncode, 0, found.stdout + found.stderr)

    def test_takes_what_is_right(self):
        (self.folder / "right.py").write_text(RIGHT)
        found = mypy(self.folder, "right.py")
        self.assertEqual(found.returncode, 0, found.stdout + found.stderr)

    def test_finds_each_line_that_is_wrong(self):
        (self.folder / "wrong.py").write_text(WRONG)
        found = mypy(self.folder, "wrong.py")
        lines = {int(number) for number in re.findall(r"^wrong\.py:(\d+): error", found.stdout, re.M)}
        self.assertEqual(lines, set(range(3, WRONG.count("\n") + 1)), found.stdout)


if __name__ == "__main__":
    unittest.main()
