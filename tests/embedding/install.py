"""Installs one form of the package, archives or libraries, with headers and program, or with `both` all there is, and moves
it to PREFIX: no file may say where it was installed first.
    install.py CMAKE BUILD_FOLDER archives|libraries|both PREFIX"""

import pathlib
import shutil
import subprocess
import sys

cmake, build, form, prefix = sys.argv[1:]
first = pathlib.Path(prefix + "_before_it_was_moved")
for folder in [first, prefix]:
    shutil.rmtree(folder, ignore_errors=True)
components = [["--component", name] for name in ["development", "program", form]] if form != "both" else [[]]
for component in components:
    subprocess.run([cmake, "--install", build, "--prefix", first, *component], check=True, stdout=subprocess.DEVNULL)
first.rename(prefix)

# The program finds the scenes that were installed with it: one that is nowhere else.
scenes = pathlib.Path(prefix, "share", "pinball", "data", "scenes")
scene = scenes / "installed_only.toml"
shutil.copy(scenes / "two_bars.toml", scene)
subprocess.run([pathlib.Path(prefix, "bin", "pinball"), "info", "installed_only"], check=True)
scene.unlink()
