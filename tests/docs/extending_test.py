"""What docs/extending.md shows as a difference can be added as it stands there.

    extending_test.py                       each fits this tree, and touches as few files as the page promises
    extending_test.py CMAKE FOLDER          a copy of the tree with it is built, and has what it adds
"""

import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BLOCK = re.compile(r"<!-- run by tests/docs/extending_test\.py -->\n```diff\n(.*?)```\n", re.S)
DIFFERENCES = BLOCK.findall((ROOT / "docs" / "extending.md").read_text())
# What each of them touches at most, in the order of the page: a limit of failure, a key, a column.
MOST_FILES = [5, 4, 3]
SOURCES = ["CMakeLists.txt", "CMakePresets.json", "VERSION", "cmake", "data", "docs", "kernels", "packaging", "python", "solver"]


def files_of(difference):
    return re.findall(r"^\+\+\+ b/(.*)$", difference, re.M)


def apply(difference, tree):
    run = subprocess.run(["patch", "--strip=1", "--fuzz=0", "--no-backup-if-mismatch"], input=difference, text=True, cwd=tree,
                         capture_output=True)
    assert run.returncode == 0, run.stdout + run.stderr


def check_that_it_fits():
    assert len(DIFFERENCES) == len(MOST_FILES), f"docs/extending.md shows {len(DIFFERENCES)} differences"
    for difference, most in zip(DIFFERENCES, MOST_FILES):
        files = files_of(difference)
        assert 0 < len(files) <= most, files
        with tempfile.TemporaryDirectory() as folder:
            for name in files:
                (pathlib.Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / name, pathlib.Path(folder) / name)
            apply(difference, folder)


def run(program, *words):
    return subprocess.run([program, *words], capture_output=True, text=True, env={**os.environ, "GOMP_SPINCOUNT": "1000"})


def steps_of(program, folder, *words):
    done = run(program, "run", "two_blocks", "--quiet", "--out", str(folder), *words)
    assert done.returncode == 0, done.stderr
    assert "time.largest_step" in (folder / "index.html").read_text()
    return json.loads((folder / "summary.json").read_text())["steps"]


def check_the_key(program, tree):
    """time.largest_step is a key as any other."""
    assert "time.largest_step" in run(program, "schema", "--keys").stdout.split()
    wrong = run(program, "info", "two_blocks", "--set", "time.largest_step=-1")
    assert wrong.returncode == 2 and "--set time.largest_step=-1: expected a number >= 0, got -1" in wrong.stderr, wrong.stderr
    few = steps_of(program, tree / "few")
    summary = json.loads((tree / "few" / "summary.json").read_text())
    many = steps_of(program, tree / "many", "--set", f"time.largest_step={summary['dt']['max'] / 4}")
    assert many > 3 * few, (few, many)
    subprocess.run([sys.executable, "docs/scene-keys", "--fix", "--program", program], cwd=tree, check=True)
    row = "| `largest_step` | number >= 0 | T | `0.0` | no step is longer; 0: as long as is stable |"
    assert row in (tree / "data/scenes/README.md").read_text()


def check_the_limit_and_the_column(program, tree):
    """Of a plate that is flung apart no element fails so early by its strain; by its swelling some do."""
    living = {}
    for swelling in ("1", "1e-4"):
        out = tree / f"swelling_{swelling}"
        done = run(program, "run", "fragmenting_plate", "--quiet", "--set", "time.end=0.002", "--set",
                   f"material.aluminium.erosion.swelling={swelling}", "--out", str(out))
        assert done.returncode == 0, done.stderr
        with open(out / "history.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
        eroded = json.loads((out / "summary.json").read_text())["bodies"][0]["eroded_elements"]
        living[swelling] = int(float(rows[-1]["living_elements"]))
        assert living[swelling] == 7200 - eroded, (living, eroded)
    assert living["1"] == 7200 and living["1e-4"] < 7200, living


def main():
    check_that_it_fits()
    if not sys.argv[1:]:
        return
    cmake, tree = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(tree, ignore_errors=True)
    tree.mkdir(parents=True)
    for name in SOURCES:
        copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
        if (ROOT / name).exists():
            copy(ROOT / name, tree / name)
    for difference in DIFFERENCES:
        apply(difference, tree)
    options = ["-DPINBALL_TESTS=OFF", "-DPINBALL_BENCH=OFF", "-DPINBALL_PYTHON=OFF", "-DPINBALL_INSTALL=OFF", "-DPINBALL_WERROR=ON"]
    build = tree / "build" / "release"
    subprocess.run([cmake, "--preset", "release", *options], cwd=tree, check=True, stdout=subprocess.DEVNULL)
    subprocess.run([cmake, "--build", build, "--target", "pinball"], check=True, stdout=subprocess.DEVNULL)
    check_the_key(build / "pinball", tree)
    check_the_limit_and_the_column(build / "pinball", tree)
    shutil.rmtree(tree)


if __name__ == "__main__":
    main()
