"""Installs the Python package with the program, moves all of it, and runs a scene that is nowhere else, with nothing but
PYTHONPATH set:
    install_test.py CMAKE BUILD_FOLDER PYTHON_DIRECTORY FOLDER"""

import os
import pathlib
import shutil
import subprocess
import sys

cmake, build, directory, folder = sys.argv[1:]
first, prefix = pathlib.Path(folder, "before_it_was_moved"), pathlib.Path(folder, "prefix")
shutil.rmtree(folder, ignore_errors=True)
components = ["python", "program"]
if (pathlib.Path(build) / "CMakeCache.txt").read_text().find("BUILD_SHARED_LIBS:BOOL=ON") >= 0:
    components.append("libraries")
for component in components:
    subprocess.run([cmake, "--install", build, "--prefix", first, "--component", component], check=True,
                   stdout=subprocess.DEVNULL)
first.rename(prefix)
scenes = prefix / "share" / "pinball" / "data" / "scenes"
(scenes / "two_bars.toml").rename(scenes / "installed_only.toml")

environment = {key: value for key, value in os.environ.items() if not key.startswith(("PINBALL", "LD_"))}
environment["PYTHONPATH"] = str(prefix / directory)
program = """
import pathlib, pinball, sys
prefix = pathlib.Path(sys.argv[1])
assert pathlib.Path(pinball.__file__).is_relative_to(prefix), pinball.__file__
libraries = [line.split()[-1] for line in open("/proc/self/maps") if "libpinball" in line]
assert all(pathlib.Path(library).is_relative_to(prefix) for library in libraries), libraries
scene = pinball.read_scene("installed_only")
assert pathlib.Path(scene.path).is_relative_to(prefix), scene.path
simulation = pinball.Simulation(scene)
assert simulation.run()
print(f"pinball {pinball.__version__}: {simulation.steps} steps, libraries: {sorted(set(libraries))}")
"""
subprocess.run([sys.executable, "-c", program, prefix], check=True, env=environment, cwd=folder)
