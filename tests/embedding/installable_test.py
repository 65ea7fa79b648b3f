"""The target `installable`, which ./run builds, makes every file that cmake --install copies from the build folder, and
builds no test:
    installable_test.py BUILD_FOLDER NINJA"""

import pathlib
import re
import subprocess
import sys

QUOTED = re.compile(r'"([^"\n]+)"')


def scripts(script):
    """The text of an install script and of those that it includes."""
    text = script.read_text()
    return text + "".join(scripts(pathlib.Path(name)) for name in re.findall(r'include\("(.*cmake_install.cmake)"\)', text))


def copied(build):
    """Files of the build folder that its install scripts name and that a step of the build makes."""
    blocks = re.findall(r"file\(INSTALL (.*?)\)\n", scripts(build / "cmake_install.cmake"), re.S)
    named = {name for block in blocks for name in QUOTED.findall(block)}
    return {name for name in named if name.startswith(f"{build}/") and re.search(r"\.(a|so[.\d]*)$|/pinball$", name)
            and not re.search("/(archives|completions)/", name)}  # made when the build is configured


def main():
    build, ninja = pathlib.Path(sys.argv[1]), sys.argv[2]
    text = subprocess.run([ninja, "-C", build, "-t", "query", "installable"], check=True, capture_output=True, text=True)
    made = {str(build / name) for name in text.stdout.split()}
    wanted = copied(build)
    # Links with the version of the interface and without one are made with the library.
    missing = {name for name in wanted if name not in made and re.sub(r"(\.so)[.\d]+$", r"\1", name) not in made}
    print(*sorted(wanted), sep="\n")
    assert len(wanted) >= 2, wanted
    assert not missing, f"installed, and not built for it: {missing}"
    tests = {name for name in made if name.endswith("_test")}
    assert not tests, f"built for nothing: {tests}"


if __name__ == "__main__":
    main()
