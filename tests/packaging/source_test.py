"""The archive of the sources unpacks, and makes the package for Debian where no network can be reached and no git is.
What is tested is how it is packed: it is compiled with less effort, and for one level of x86-64 beside the first. All that
docs/extending.md adds is added before, so that one build shows of both that they compile, and that each addition does what
it says.

    source_test.py CMAKE BUILD_FOLDER FOLDER            looks what is in it
    source_test.py CMAKE BUILD_FOLDER FOLDER test       configures it, and runs tests of the tree itself, without a git
    source_test.py CMAKE BUILD_FOLDER FOLDER build      builds it, too; leaves FOLDER/pinball.deb and FOLDER/levels
"""

import os
import pathlib
import shutil
import subprocess
import sys
import tarfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LEVEL = "x86-64-v3"
sys.path.insert(0, str(ROOT / "tests" / "docs"))

import extending_checks
import extending_test


def without_network():
    """The words before a command that take the network from it."""
    for command in [["unshare", "--net"], ["unshare", "--map-root-user", "--net"]]:
        if subprocess.run([*command, "true"], capture_output=True).returncode == 0:
            return command
    print("The network stays within reach: this machine lets nobody go without it")
    return []


def check_files(archive):
    """All that git would give away, and nothing that was built."""
    with tarfile.open(archive) as file:
        names = {name.split("/", 1)[1] for name in file.getnames() if "/" in name}
    built = {name for name in names if name.split("/")[0] in {"build", "out", ".git"} or "__pycache__" in name}
    assert not built, sorted(built)[:10]
    if (ROOT / ".git").exists():
        tracked = subprocess.run(["git", "-C", ROOT, "ls-files"], check=True, capture_output=True, text=True)
        missing = {name for name in tracked.stdout.splitlines() if (ROOT / name).is_file()} - names
        assert not missing, sorted(missing)[:10]


def check_tests(cmake, tree):
    """The tree configures, and those of its tests pass that look at the tree alone, where no git is."""
    programs = tree.parent / "programs"
    programs.mkdir()
    for folder in ["/bin", "/usr/bin", str(pathlib.Path(cmake).parent)]:  # of one name the last counts
        for path in pathlib.Path(folder).iterdir():
            if not path.name.startswith("git"):
                (programs / path.name).unlink(missing_ok=True)
                (programs / path.name).symlink_to(path)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    environment["PATH"] = str(programs)
    assert shutil.which("git", path=environment["PATH"]) is None
    subprocess.run(["cmake", "--preset", "release"], check=True, cwd=tree, env=environment, stdout=subprocess.DEVNULL)
    tests = "^(packaging_archive|packaging_install_packages|packaging_build_release|rooms)$"
    run = subprocess.run(["ctest", "--test-dir", "build/release", "--output-on-failure", "-R", tests], cwd=tree, env=environment,
                         capture_output=True, text=True)
    print(run.stdout)
    assert run.returncode == 0 and "100% tests passed, 0 tests failed out of 4" in run.stdout, run.stderr


def main():
    cmake, build, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]).resolve()
    cpack = pathlib.Path(cmake).parent / "cpack"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    subprocess.run([cpack, "-G", "TGZ", "--config", build / "CPackSourceConfig.cmake", "-B", folder], check=True)
    archive, = folder.glob("pinball-*.tar.gz")
    check_files(archive)
    if not sys.argv[4:]:
        return
    subprocess.run(["tar", "-C", folder, "-xzf", archive], check=True)
    tree, = (path for path in folder.iterdir() if path.is_dir() and not path.name.startswith("_"))
    if sys.argv[4] == "test":
        check_tests(cmake, tree)
        shutil.rmtree(folder)
        return

    for difference in extending_test.differences():
        extending_test.apply(difference, tree)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    offline = without_network()
    for command in [[cmake, "--preset", "package", f"-DPINBALL_HWCAPS={LEVEL}", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                     "-DPINBALL_WERROR=ON"],
                    [cmake, "--build", "--preset", "package"], [cpack, "--preset", "package"]]:
        subprocess.run([*offline, *command], check=True, cwd=tree, env=environment)
    package, = (tree / "build" / "package").glob("*.deb")
    shutil.copy(package, folder / "pinball.deb")
    (folder / "levels").write_text(LEVEL)
    extending_checks.check_all(tree / "build" / "package" / "pinball", tree)
    shutil.rmtree(tree)


if __name__ == "__main__":
    main()
