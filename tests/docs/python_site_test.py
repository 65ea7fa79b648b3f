"""The reference of the Python package is made without a warning, and has all that the package has.

    python_site_test.py SPHINX SOURCES FOLDER    SOURCES: docs/python; FOLDER: to make it in
"""

import inspect
import pathlib
import shutil
import subprocess
import sys

import pinball
import site_test


def public_members():
    """Anchors of all functions and classes, and of what these have themselves."""
    for name, value in vars(pinball).items():
        if name.startswith("_") or inspect.ismodule(value) or not callable(value):
            continue
        yield f"pinball.{name}"
        is_list = (inspect.getdoc(value) or "").startswith("A list of ")
        if inspect.isclass(value) and not is_list:
            yield from (f"pinball.{name}.{member}" for member in vars(value) if not member.startswith("_"))


def main():
    sphinx, sources, folder = sys.argv[1:]
    folder = pathlib.Path(folder)
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(sources, folder / "sources")
    subprocess.run([sphinx, "-q", "-W", "--keep-going", "-d", folder / "doctrees", folder / "sources", folder / "html"], check=True)
    text = "".join(page.read_text() for page in (folder / "html").glob("*.html"))
    missing = sorted(name for name in public_members() if f'id="{name}"' not in text)
    for name in missing:
        print(f"no entry of {name}", file=sys.stderr)
    dead = site_test.dead_links(folder / "html")
    for page, link in dead:
        print(f"{page}: {link}", file=sys.stderr)
    return 1 if missing or dead else 0


if __name__ == "__main__":
    sys.exit(main())
