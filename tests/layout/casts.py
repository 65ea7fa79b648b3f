"""How many casts product code has: `static_cast` in kernels/ and solver/, per 100 lines.

    casts.py [TREE]      prints the count of each room, the most first; exit status 1 if there are too many in all

A cast is for what changes a value or the width of a sum or product (CONTRIBUTING.md, Style). What counts nodes, elements or
rows has the type that its use wants where it is declared.
"""

import pathlib
import re
import sys

import checked_tree

MOST = 0.78  # per 100 lines

SOURCES = (".cpp", ".hpp", ".h", ".cu", ".cuh")
CAST = re.compile(r"\bstatic_cast\s*<")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)


def counts(tree):
    """{folder: (casts, lines)} of kernels/ and solver/, with two names of folders."""
    tree = pathlib.Path(tree)
    found = {}
    for file in sorted(file for room in ("kernels", "solver") for file in (tree / room).rglob("*") if file.suffix in SOURCES):
        text = file.read_text()
        folder = "/".join(file.relative_to(tree).parent.parts[:2])
        casts, lines = found.get(folder, (0, 0))
        found[folder] = (casts + len(CAST.findall(COMMENT.sub("", text))), lines + text.count("\n"))
    return found


def per_100_lines(found):
    casts, lines = (sum(numbers) for numbers in zip(*found.values()))
    return 100 * casts / lines


def most_first(found):
    rows = sorted(found.items(), key=lambda row: -row[1][0])
    return "\n".join(f"{folder}: {casts} in {lines} lines" for folder, (casts, lines) in rows)


if __name__ == "__main__":
    FOUND = counts(checked_tree.chosen())
    RATIO = per_100_lines(FOUND)
    print(f"{most_first(FOUND)}\n{RATIO:.2f} per 100 lines, {MOST} at most")
    sys.exit(1 if RATIO > MOST else 0)
