"""Where archives and shared libraries are installed side by side, hosts built with pkg-config --static contain the
archives, and those without it load the libraries. CMake's own search goes by the same files.
    archives_beside_libraries_test.py PREFIX BUILD_WITH_PKG_CONFIG FOLDER"""

import os
import pathlib
import re
import subprocess
import sys


def needed(program):
    text = subprocess.run(["readelf", "-d", program], check=True, capture_output=True, text=True).stdout
    return re.findall(r"\(NEEDED\).*\[libpinball-(\w+)\.so", text)


def pkg_config(prefix, *arguments):
    environment = {**os.environ, "PKG_CONFIG_PATH": str(next(prefix.glob("**/pinball-contact.pc")).parent)}
    return subprocess.run(["pkg-config", *arguments], check=True, capture_output=True, text=True, env=environment).stdout.split()


def linked(prefix, package, *static):
    """Libraries of Pinball that a link with these flags takes, as the linker traces them."""
    flags = pkg_config(prefix, *static, "--libs", package)
    command = ["c++", "-shared", "-o", "/dev/null", "-Wl,--trace", *flags]
    trace = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return {pathlib.Path(line.strip("()")).name for line in re.findall(r"\S*libpinball-[a-z]+\.(?:a|so)", trace)}


def main():
    prefix, build, folder = (pathlib.Path(argument) for argument in sys.argv[1:])
    for form, expected in {"archives": [], "libraries": ["contact"]}.items():
        subprocess.run([build, prefix, form, folder / form], check=True)
        for host in [host for host in ["two_bars_c", "two_bars_fortran"] if (folder / form / host).exists()]:
            assert needed(folder / form / host) == expected, f"{form}: {host} loads {needed(folder / form / host)}"
            subprocess.run([folder / form / host], check=True, stdout=subprocess.DEVNULL)

    assert linked(prefix, "pinball-solver") == {"libpinball-solver.so"}, linked(prefix, "pinball-solver")
    static = linked(prefix, "pinball-solver", "--static")
    assert static == {"libpinball-solver.a", "libpinball-contact.a"}, static


if __name__ == "__main__":
    main()
