"""The archive of the sources unpacks, and makes the package for Debian where no network can be reached and no git is.
What is tested is how it is packed: it is compiled with less effort, and for one level of x86-64 beside the first.

    source_test.py CMAKE BUILD_FOLDER FOLDER            looks what is in it
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
    tracked = subprocess.run(["git", "-C", ROOT, "ls-files"], capture_output=True, text=True)
    if tracked.returncode == 0:
        missing = {name for name in tracked.stdout.splitlines() if (ROOT / name).is_file()} - names
        assert not missing, sorted(missing)[:10]


def main():
    cmake, build, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]).resolve()
    cpack = pathlib.Path(cmake).parent / "cpack"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    subprocess.run([cpack, "-G", "TGZ", "--config", build / "CPackSourceConfig.cmake", "-B", folder], check=True)
    archive, = folder.glob("pinball-*.tar.gz")
    check_files(archive)
    if sys.argv[4:] != ["build"]:
        return
    subprocess.run(["tar", "-C", folder, "-xzf", archive], check=True)
    tree, = (path for path in folder.iterdir() if path.is_dir() and not path.name.startswith("_"))

    environment = {name: value for name, value in os.environ.items() if not name.startswith("GIT_")}
    offline = without_network()
    for command in [[cmake, "--preset", "package", f"-DPINBALL_HWCAPS={LEVEL}", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"],
                    [cmake, "--build", "--preset", "package"], [cpack, "--preset", "package"]]:
        subprocess.run([*offline, *command], check=True, cwd=tree, env=environment)
    package, = (tree / "build" / "package").glob("*.deb")
    shutil.copy(package, folder / "pinball.deb")
    (folder / "levels").write_text(LEVEL)
    shutil.rmtree(tree)


if __name__ == "__main__":
    main()
