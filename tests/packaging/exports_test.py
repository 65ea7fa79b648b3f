"""The program finds what it calls in shared libraries, too, where all is hidden that is not marked PINBALL_API: each
symbol of pinball that its own objects lack is defined in the library of the program, and not hidden.

    exports_test.py LIBRARY OBJECT...
"""

import re
import subprocess
import sys


def symbols(file):
    """Rows (visibility, is defined, name) of what is not local."""
    text = subprocess.run(["readelf", "--syms", "--wide", file], check=True, capture_output=True, text=True).stdout
    row = re.compile(r" (?:GLOBAL|WEAK) +(DEFAULT|HIDDEN|PROTECTED|INTERNAL) +(\S+) (\S+)$", re.M)
    return [(visibility, section != "UND", name) for visibility, section, name in row.findall(text)]


def main():
    library, objects = sys.argv[1], sys.argv[2:]
    exported = {name for visibility, defined, name in symbols(library) if defined and visibility == "DEFAULT"}
    of_objects = [row for file in objects for row in symbols(file)]
    here = {name for _, defined, name in of_objects if defined}
    called = {name for _, defined, name in of_objects if not defined and "7pinball" in name} - here
    assert "_ZN7pinball11run_commandERKNS_10RunOptionsE" in called, called
    hidden = called - exported
    assert not hidden, f"not exported by {library}: {sorted(hidden)}"
    print(f"{len(called)} symbols, all exported")


if __name__ == "__main__":
    main()
