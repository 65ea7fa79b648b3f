"""Faults with a name, of named/*.toml: each a piece of text that its file has once."""

import glob
import os
import tomllib

from report_parts.builds import ROOT

from .fault import EXPRESSION, Fault

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "named")


def text_of(file):
    with open(os.path.join(ROOT, file), encoding="utf-8") as source:
        return source.read()


def placed(entry):
    """None where the text has gone: the fault is one to be written anew. end: what follows the text, where that alone stands
    there more than once."""
    text, wanted = text_of(entry["file"]), entry["right"] + entry.get("end", "")
    if text.count(wanted) != 1:
        return None
    return Fault(entry["file"], entry["right"], entry["wrong"], entry.get("form", EXPRESSION), what=entry["what"], begin=text.index(wanted))


def all_named():
    """(faults, what is said of those whose texts have gone)"""
    faults, gone = [], []
    for path in sorted(glob.glob(os.path.join(FOLDER, "*.toml"))):
        with open(path, "rb") as file:
            entries = tomllib.load(file)["fault"]
        for entry in entries:
            fault = placed(entry) if os.path.exists(os.path.join(ROOT, entry["file"])) else None
            if fault is None:
                gone.append(f"{os.path.relpath(path, ROOT)}: {entry['what']}: {entry['file']} no longer has `{entry['right']}` once")
            else:
                faults.append(fault)
    return faults, gone
