"""Makes the wheel of what is built, installs it where there is nothing else, and runs a scene of its own with it; and looks
how a wheel would be built for itself:
    wheel_test.py BUILD_FOLDER FOLDER"""

import os
import pathlib
import shutil
import subprocess
import sys
import zipfile

build, folder = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
root = pathlib.Path(__file__).resolve().parent.parent.parent
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
environment = {key: value for key, value in os.environ.items() if not key.startswith(("PINBALL", "PYTHON", "PIP"))}
subprocess.run([sys.executable, "-m", "pip", "wheel", root, "--no-build-isolation", "--no-deps", "--no-index", "--quiet",
                "--disable-pip-version-check", "--wheel-dir", folder, f"--config-settings=build={build}"], check=True, env=environment)
(wheel,) = folder.glob("*.whl")
with zipfile.ZipFile(wheel) as content:
    assert content.testzip() is None
    names = content.namelist()
assert "pinball/data/scenes/two_bars.toml" in names, names
assert not any("__pycache__" in name for name in names), names

subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", folder / "venv"], check=True, env=environment)
python = folder / "venv" / "bin" / "python3"
subprocess.run([python, "-m", "pip", "install", "--no-index", "--no-deps", "--quiet", "--disable-pip-version-check", wheel],
               check=True, env=environment)
program = """
import importlib.metadata, pathlib, pinball, sys
assert pathlib.Path(pinball.__file__).is_relative_to(sys.prefix), pinball.__file__
assert importlib.metadata.version("pinball-solver") == pinball.__version__
scene = pinball.read_scene("two_bars")
assert pathlib.Path(scene.path).is_relative_to(sys.prefix), scene.path
simulation = pinball.Simulation(scene)
assert simulation.run()
print(f"pinball {pinball.__version__}: {simulation.steps} steps, state {simulation.state_hash:016x}")
"""
subprocess.run([python, "-c", program], check=True, env=environment, cwd=folder)

# One that is built for itself is configured as it should be, and has what it is made of.
subprocess.run([sys.executable, "-c", f"import cmake_wheel, pathlib; cmake_wheel.configure(pathlib.Path({str(folder / 'anew')!r}))"],
               check=True, cwd=root / "packaging" / "wheel", stdout=subprocess.DEVNULL,
               env={**environment, "CMAKE_ARGS": "-DPINBALL_NATIVE=OFF '-DCMAKE_CXX_FLAGS=-DONE -DTWO'", "PYTHONDONTWRITEBYTECODE": "1"})
cache = set((folder / "anew" / "CMakeCache.txt").read_text().splitlines())
expected = {"CMAKE_BUILD_TYPE:STRING=Release", "PINBALL_TESTS:BOOL=OFF", "PINBALL_BENCH:BOOL=OFF", "PINBALL_PYTHON:BOOL=ON",
            "BUILD_SHARED_LIBS:BOOL=OFF", "PINBALL_NATIVE:BOOL=OFF", "CMAKE_CXX_FLAGS:STRING=-DONE -DTWO"}
assert expected <= cache, expected - cache
subprocess.run(["ninja", "-C", folder / "anew", "-n", "pinball_python"], check=True, stdout=subprocess.DEVNULL)
