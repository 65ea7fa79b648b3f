"""What compilers say of the loops that they have, or have not, vectorized."""

import os
import re
from dataclasses import dataclass, field

GCC_REMARK = re.compile(r"^(.*?):(\d+):\d+: (optimized|missed|note):\s*(.*)$")
GCC_LOOP = re.compile(r"loop vectorized using (\d+) byte vectors")
GCC_BLOCK = re.compile(r"basic block part vectorized using (\d+) byte vectors")
GCC_EPILOGUE = re.compile(r"epilogue|loop versioned|loop peeled")


@dataclass
class Remarks:
    """Remarks on the loops of one function."""
    loops: list = field(default_factory=list)  # vectorized: (place, text)
    blocks: list = field(default_factory=list)  # straight code of which a part was vectorized: (place, text)
    refused: list = field(default_factory=list)  # (place, reason)

    @property
    def verdict(self):
        if self.loops and not self.refused:
            return "yes"
        if self.loops or self.blocks:
            return "partly"
        return "no"

    def add(self, other):
        for name in ("loops", "blocks", "refused"):
            for place, text in getattr(other, name):
                add_once(getattr(self, name), place, text)

    def texts(self):
        return [f"{place}: {text}" for group in (self.loops, self.blocks, self.refused) for place, text in group]


def short(path):
    """kernels/x.hpp or solver/x.cpp, wherever the tree lies."""
    parts = os.path.normpath(path).split("/")
    for i in range(len(parts) - 1, -1, -1):
        if parts[i] in ("kernels", "solver", "experimental", "bits", "include"):
            return "/".join(parts[i:])
    return parts[-1]


def add_once(group, place, text):
    if (place, text) not in group:
        group.append((place, text))


def shared(path):
    """Headers whose loops are in many functions: their remarks cannot be told apart by the line."""
    return path.startswith(("bits/", "include/")) or path == "kernels/exec.hpp"


def parse_gcc(text, lines):
    """Remarks of `-fopt-info-vec-all` on loops at any of the source lines: a set of (file, line). Those on lines of the
    standard library and of the parallel loops themselves, which all kernels share, are left out.

    Refusals carry the first reason given for the loop; gcc repeats them for every vector size that it tries.
    """
    wanted = {(short(path), line) for path, line in lines}
    result = Remarks()
    refused_at, reasons = set(), {}
    for line in text.splitlines() if isinstance(text, str) else text:
        match = GCC_REMARK.match(line)
        if not match:
            continue
        path, number, kind, message = match.group(1), int(match.group(2)), match.group(3), match.group(4)
        where = (short(path), number)
        if where not in wanted or shared(where[0]) or GCC_EPILOGUE.search(message):
            continue
        place = f"{where[0]}:{number}"
        if kind == "optimized":
            if GCC_LOOP.search(message):
                add_once(result.loops, place, message)
            elif GCC_BLOCK.search(message):
                add_once(result.blocks, place, message)
        elif kind == "missed":
            if "couldn't vectorize loop" in message:
                refused_at.add(place)
            elif message.startswith("not vectorized"):
                reasons.setdefault(place, message)
    vectorized = {place for place, _ in result.loops}
    for place in sorted(refused_at - vectorized):
        add_once(result.refused, place, reasons.get(place, "couldn't vectorize loop"))
    return result


YAML_START = re.compile(r"^--- !(\w+)")
YAML_KEY = re.compile(r"^(\w+):\s+(.*)$")
YAML_PLACE = re.compile(r"File: '?([^',]+)'?,\s*Line: (\d+)")
YAML_TEXT = re.compile(r"^\s+-\s+(\w+):\s+(.*)$")


def yaml_documents(text):
    """(kind, pass, name, function, (file, line) or None, message) of each document of the optimization record."""
    document, keys, message = None, {}, []
    for line in (text.splitlines() if isinstance(text, str) else text):
        line = line.rstrip("\n")
        start = YAML_START.match(line)
        if start:
            document, keys, message = start.group(1), {}, []
            continue
        if document is None:
            continue
        if line.startswith("..."):
            place = YAML_PLACE.search(keys.get("DebugLoc", ""))
            yield (document, keys.get("Pass", ""), keys.get("Name", ""), keys.get("Function", "").strip("'"),
                   (place.group(1), int(place.group(2))) if place else None, "".join(message))
            document = None
            continue
        key = YAML_KEY.match(line)
        if key:
            last = key.group(1)
            keys[last] = key.group(2)
            continue
        part = YAML_TEXT.match(line)
        if part:
            if part.group(1) != "DebugLoc":
                value = part.group(2)
                message.append(value[1:-1].replace("''", "'") if value[:1] == "'" else value.strip('"'))
        elif line.startswith("    ") and "DebugLoc" not in line and "DebugLoc" in keys and "Line:" not in keys["DebugLoc"]:
            keys["DebugLoc"] += line.strip()
        elif line.startswith("  ") and "DebugLoc" in keys and "Line:" not in keys["DebugLoc"]:
            keys["DebugLoc"] += " " + line.strip()


def parse_clang(text, functions):
    """Remarks of clang's YAML record on functions: patterns for their mangled names."""
    patterns = [re.compile(p) for p in functions]
    result = Remarks()
    for kind, which, name, function, place, message in yaml_documents(text):
        if which not in ("loop-vectorize", "slp-vectorizer") or not any(p.search(function) for p in patterns):
            continue
        if place and shared(short(place[0])):
            continue
        where = f"{short(place[0])}:{place[1]}" if place else "?"
        if kind == "Passed" and which == "loop-vectorize" and name == "Vectorized":
            add_once(result.loops, where, message)
        elif kind == "Passed" and which == "slp-vectorizer":
            add_once(result.blocks, where, message)
        elif kind == "Analysis" and which == "loop-vectorize":  # the reason
            add_once(result.refused, where, message)
    vectorized = {place for place, _ in result.loops}
    result.refused = [(place, text) for place, text in result.refused if place not in vectorized]
    return result
