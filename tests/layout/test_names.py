"""Test files of a folder are one program: each has a namespace of its own name, no other has a test of the same name, and
files that tests write lie in folders of their own, since tests run side by side.

    test_names.py [TREE]          prints what is not so; exit status 1 if there is something
"""

import pathlib
import re
import sys

import checked_tree

NAMESPACE = re.compile(r"^namespace (pinball(?:::\w+)*) \{$", re.M)
TEST = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", re.M)


def problems(tree):
    tree = pathlib.Path(tree).resolve()
    wrong, first = [], {}
    for file in sorted((tree / "tests").rglob("*_test.cpp")):
        place, text = file.relative_to(tree), file.read_text()
        for name in NAMESPACE.findall(text):
            if name.split("::")[-1] != file.stem:
                wrong.append(f"{place}: namespace {name}::{file.stem} expected, not {name}")
        for test in TEST.findall(text):
            other = first.setdefault((file.parent, test), place)
            if other != place:
                wrong.append(f"{place}: {'.'.join(test)} is in {other}, too")
        if "TempDir()" in text:
            wrong.append(f"{place}: TempDir() is the folder of all tests: FolderTest has one for each")
    return wrong


if __name__ == "__main__":
    sys.exit(checked_tree.print_problems(problems(checked_tree.chosen())))
