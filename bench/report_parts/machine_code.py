"""What the machine code of a function does, from the text of `objdump -d -C` (x86-64)."""

import re
from dataclasses import dataclass, field

HEADER = re.compile(r"^[0-9a-f]+ <(.*)>:$")
INSTRUCTION = re.compile(r"^\s*[0-9a-f]+:\t(?:(?:lock|rep|repz|bnd|notrack) )*([a-z][a-z0-9]*)\s*(.*)$")
SOURCE_LINE = re.compile(r"^(/[^:]*|[\w.+-][^:\t]*):(\d+)(?: \(discriminator \d+\))?$")
# Arithmetic on floating-point numbers: one operation a lane, fused multiply-adds two.
ARITHMETIC = re.compile(r"^v?(?:(add|sub|mul|div|sqrt|max|min|addsub|rndscale|round|rcp14|rsqrt14)|"
                        r"(fn?m(?:add|sub|addsub|subadd)(?:132|213|231)))(pd|ps|sd|ss)$")
GATHER = re.compile(r"^vp?gather")
SCATTER = re.compile(r"^vp?scatter")
WIDTHS = {"z": 512, "y": 256, "x": 128}


@dataclass
class Counts:
    """Instructions of one or several functions."""
    instructions: int = 0
    packed: dict = field(default_factory=lambda: {"zmm": 0, "ymm": 0, "xmm": 0})  # floating-point arithmetic, by register
    scalar: int = 0
    gathers: int = 0
    scatters: int = 0
    masked: int = 0  # of the packed arithmetic
    operations: int = 0  # of all floating-point arithmetic, each instruction once
    packed_lines: dict = field(default_factory=dict)  # source file: packed arithmetic that it is attributed to
    lines: set = field(default_factory=set)  # (file, line) of all instructions

    def __iadd__(self, other):
        for name in ("instructions", "scalar", "gathers", "scatters", "masked", "operations"):
            setattr(self, name, getattr(self, name) + getattr(other, name))
        for register, n in other.packed.items():
            self.packed[register] += n
        for name, n in other.packed_lines.items():
            self.packed_lines[name] = self.packed_lines.get(name, 0) + n
        self.lines |= other.lines
        return self

    @property
    def packed_total(self):
        return sum(self.packed.values())

    @property
    def packed_fraction(self):
        """Of the floating-point arithmetic; None where there is none."""
        whole = self.packed_total + self.scalar
        return self.packed_total / whole if whole else None

    def as_dict(self):
        return {"instructions": self.instructions, **{f"packed_{r}": n for r, n in self.packed.items()},
                "scalar": self.scalar, "gathers": self.gathers, "scatters": self.scatters, "masked": self.masked,
                "operations": self.operations}


def widest_register(operands):
    for letter, bits in WIDTHS.items():
        if f"%{letter}mm" in operands:
            return letter + "mm", bits
    return None, 0


def count_instruction(counts, mnemonic, operands, source):
    counts.instructions += 1
    if GATHER.match(mnemonic):
        counts.gathers += 1
        return
    if SCATTER.match(mnemonic):
        counts.scatters += 1
        return
    match = ARITHMETIC.match(mnemonic)
    if not match:
        return
    per_lane = 2 if match.group(2) else 1
    kind = match.group(3)
    if kind in ("sd", "ss"):
        counts.scalar += 1
        counts.operations += per_lane
        return
    register, bits = widest_register(operands)
    if register is None:
        return
    counts.packed[register] += 1
    counts.masked += "{%k" in operands
    counts.operations += per_lane * bits // (64 if kind == "pd" else 32)
    if source:
        counts.packed_lines[source[0]] = counts.packed_lines.get(source[0], 0) + 1


def parse_objdump(text):
    """{demangled name: Counts}; a name that stands in several object files: {name: the first of them}.

    With source lines in the text (`objdump -l`) also where the instructions come from.
    """
    functions, name, counts, source = {}, None, None, None
    for line in text.splitlines() if isinstance(text, str) else text:
        line = line.rstrip("\n")
        header = HEADER.match(line)
        if header:
            name, source = header.group(1), None
            counts = None
            if name not in functions:
                counts = functions[name] = Counts()
            continue
        if counts is None:
            continue
        instruction = INSTRUCTION.match(line)
        if instruction:
            count_instruction(counts, instruction.group(1), instruction.group(2), source)
            if source:
                counts.lines.add(source)
            continue
        place = SOURCE_LINE.match(line)
        if place:
            source = (place.group(1), int(place.group(2)))
    return functions


def select(functions, patterns):
    """(names, sum of Counts) of the functions whose names any of the patterns finds."""
    names = [name for name in functions if any(re.search(p, name) for p in patterns)]
    whole = Counts()
    for name in names:
        whole += functions[name]
    return names, whole
