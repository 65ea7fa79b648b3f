"""What docs/extending.md shows as a difference can be added as it stands there, or in the file that it names.

    extending_test.py                       each fits this tree, and touches as few sources as the page promises
    extending_test.py CMAKE FOLDER          a copy of the tree with all of them is built, and each does what it says
"""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import extending_checks

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs" / "extending.md"
SHOWN = re.compile(r"<!-- run by tests/docs/extending_test\.py -->\n```diff\n(?P<text>.*?)```\n"
                   r"|\[\w+\.diff\]\((?P<file>extending/\w+\.diff)\) <!-- applied -->", re.S)
# What each of them is, in the order of the page, and how many sources of the product it touches at most.
MOST_SOURCES = {"a yield law": 7, "an equation of state": 7, "a failure model": 8, "a key": 4, "an element": 2, "a format": 5,
                "a card": 5, "a column": 3}
# A variable of a namespace, added to a source; and names in code, not those of members, namespaces or functions.
ADDED_VARIABLE = re.compile(r"^\+(?:inline |static )*(?:constexpr|const) [^(){}=;]*?\b(\w+)(?:\{| = |\(|;)", re.M)
PLAIN_NAME = re.compile(r"(?<![.\w:])(?<!->)[a-z]\w*\b(?!\()")
NO_CODE = re.compile(r'//[^\n]*|"(?:[^"\\\n]|\\.)*"')
OF_PRODUCT = ("kernels/", "solver/", "python/")
COPIED = ["CHANGELOG.md", "CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "cmake", "data", "docs", "kernels",
          "packaging", "pyproject.toml", "python", "solver", "tests/layout"]


def differences():
    return [shown["text"] or (PAGE.parent / shown["file"]).read_text() for shown in SHOWN.finditer(PAGE.read_text())]


def files_of(difference):
    return re.findall(r"^\+\+\+ b/(.*)$", difference, re.M)


def apply(difference, tree):
    run = subprocess.run(["patch", "--strip=1", "--fuzz=0", "--no-backup-if-mismatch"], input=difference, text=True, cwd=tree,
                         capture_output=True)
    assert run.returncode == 0, run.stdout + run.stderr


def check_that_it_fits(differences_together):
    with tempfile.TemporaryDirectory() as folder:
        for name in {name for difference in differences_together for name in files_of(difference)}:
            (pathlib.Path(folder) / name).parent.mkdir(parents=True, exist_ok=True)
            if (ROOT / name).exists():
                shutil.copy(ROOT / name, pathlib.Path(folder) / name)
        for difference in differences_together:
            apply(difference, folder)


def shadowed_in(difference):
    """(source, name) of variables that a difference adds to a source of the solver and that others of the room have as a name:
    all of them may be compiled together, with shadowed names as errors. (That they do compile, a longer test shows.)"""
    found = []
    for part in re.split(r"^--- ", difference, flags=re.M):
        source = re.search(r"^\+\+\+ b/(solver/\w+/.*\.cpp)$", part, re.M)
        added = set(ADDED_VARIABLE.findall(part)) if source else set()
        if added:
            for other in sorted((ROOT / "/".join(source[1].split("/")[:2])).rglob("*.cpp")):
                if other != ROOT / source[1]:
                    names = set(PLAIN_NAME.findall(NO_CODE.sub("", other.read_text())))
                    found += [(str(other.relative_to(ROOT)), name) for name in sorted(added & names)]
    return found


def check_that_no_name_is_shadowed(shown):
    for difference in shown:
        assert not shadowed_in(difference), f"names that other sources of the room have: {shadowed_in(difference)}"
    planted, = (text.replace("nodes_of_face", "faces") for text in shown if "nodes_of_face{{" in text)
    assert ("solver/formats/vtk/vtk_grid.cpp", "faces") in shadowed_in(planted), shadowed_in(planted)


def check_that_they_fit():
    shown = differences()
    assert len(shown) == len(MOST_SOURCES), f"docs/extending.md shows {len(shown)} differences"
    named = {PAGE.parent / match["file"] for match in SHOWN.finditer(PAGE.read_text()) if match["file"]}
    assert named == set((ROOT / "docs" / "extending").iterdir()), named
    for (what, most), difference in zip(MOST_SOURCES.items(), shown):
        files = files_of(difference)
        assert 0 < sum(name.startswith(OF_PRODUCT) for name in files) <= most, (what, files)
        check_that_it_fits([difference])
    check_that_it_fits(shown)
    check_that_no_name_is_shadowed(shown)


def main():
    check_that_they_fit()
    if not sys.argv[1:]:
        return
    cmake, tree = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    shutil.rmtree(tree, ignore_errors=True)
    tree.mkdir(parents=True)
    for name in COPIED:
        copy = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
        if (ROOT / name).exists():
            copy(ROOT / name, tree / name)
    for difference in differences():
        apply(difference, tree)
    build = tree / "build" / "release"
    options = ["-DPINBALL_TESTS=OFF", "-DPINBALL_BENCH=OFF", "-DPINBALL_PYTHON=OFF", "-DPINBALL_INSTALL=OFF", "-DPINBALL_WERROR=ON"]
    subprocess.run([cmake, "--preset", "release", *options], cwd=tree, check=True, stdout=subprocess.DEVNULL)
    subprocess.run([cmake, "--build", build, "--target", "pinball"], check=True, stdout=subprocess.DEVNULL)
    extending_checks.check_all(build / "pinball", tree)
    shutil.rmtree(tree)


if __name__ == "__main__":
    main()
