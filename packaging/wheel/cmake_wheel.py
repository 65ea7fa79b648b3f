"""Builds the wheel of the Python package with CMake, for pip and build (PEP 517). What the wheel holds is what
`cmake --install` copies, component python, and the scenes.

    pip wheel . --no-build-isolation --no-deps [--config-settings=build=FOLDER]

build: a folder that CMake has configured; else one is made for this wheel. CMAKE_ARGS in the environment is handed to CMake;
the library is compiled for this machine unless it has -DPINBALL_NATIVE=OFF."""

import os
import pathlib
import re
import shlex
import subprocess
import sys
import sysconfig
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
CONFIGURATION = ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DPINBALL_TESTS=OFF", "-DPINBALL_BENCH=OFF",
                 "-DPINBALL_PYTHON=ON", "-DBUILD_SHARED_LIBS=OFF"]


def version():
    """From the one place where it stands."""
    text = (ROOT / "solver" / "base" / "version.h").read_text()
    return ".".join(re.findall(r"^#define PINBALL_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", text, re.M))


def metadata():
    description = re.search(r'DESCRIPTION "([^"]*)"', (ROOT / "CMakeLists.txt").read_text()).group(1)
    return (f"Metadata-Version: 2.1\nName: pinball-solver\nVersion: {version()}\nSummary: {description}\n"
            f"Requires-Python: =={sys.version_info.major}.{sys.version_info.minor}.*\nRequires-Dist: numpy\n"
            "License-File: LICENSE\n")


def run(*command):
    subprocess.run(command, check=True, cwd=ROOT)


def configure(build):
    """Configures a folder to build in, if that has not been done."""
    if not (build / "CMakeCache.txt").exists():
        run("cmake", "-S", ROOT, "-B", build, *CONFIGURATION, f"-DPython_EXECUTABLE={sys.executable}",
            *shlex.split(os.environ.get("CMAKE_ARGS", "")))


def install(build, staging):
    """Builds what is needed and copies it. Returns the folder of the package."""
    configure(build)
    run("cmake", "--build", build, "--target", "pinball_python")
    run("cmake", "--install", build, "--component", "python", "--prefix", staging)
    found = list(staging.rglob("pinball/__init__.py"))
    if len(found) != 1:
        sys.exit(f"{build}: there is no Python package to install: pybind11 and the headers of Python are needed")
    return found[0].parent


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    from wheel.wheelfile import WheelFile

    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag, info = f"{python}-{python}-{platform}", f"pinball_solver-{version()}.dist-info"
    name = f"pinball_solver-{version()}-{tag}.whl"
    with tempfile.TemporaryDirectory() as temporary:
        build = pathlib.Path((config_settings or {}).get("build", pathlib.Path(temporary, "build"))).resolve()
        package = install(build, pathlib.Path(temporary, "staging"))
        with WheelFile(str(pathlib.Path(wheel_directory, name)), "w") as wheel:
            for file in sorted(package.rglob("*")):
                if file.is_file() and "__pycache__" not in file.parts:
                    wheel.write(str(file), f"pinball/{file.relative_to(package)}")
            for file in sorted((ROOT / "data" / "scenes").rglob("*")):
                if file.is_file():
                    wheel.write(str(file), f"pinball/data/scenes/{file.relative_to(ROOT / 'data' / 'scenes')}")
            wheel.write(str(ROOT / "LICENSE"), f"{info}/LICENSE")
            wheel.writestr(f"{info}/METADATA", metadata())
            wheel.writestr(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: cmake_wheel\nRoot-Is-Purelib: false\nTag: {tag}\n")
    return name
