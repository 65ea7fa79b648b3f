"""Faults written by rule: what may be wrong in a line of source text without the compiler telling."""

import re

from .fault import STATEMENT, Fault

# A value that is given to something or returned; the text up to the semicolon is one expression.
VALUE = re.compile(
    r"^(?P<head> {2,}(?:return |(?P<type>(?:const )?(?:double|float|S|T|bool|auto|int|std::size_t|std::int(?:32|64)_t|Vec3<\w+>|Point)"
    r") \w+ = |[\w.\->\[\]()]+ [-+*/]?= ))(?P<value>[^;{}\"]+);$", re.M)
CALL_OR_ASSIGNMENT = re.compile(
    r"^ {2,}(?P<statement>(?:[A-Za-z_][\w:.\->\[\]]*\([^;{}\"]*\)|[A-Za-z_][\w.\->\[\]]*(?:\(\w*\))? [-+*/|]?= [^;{}\"]+);)$", re.M)
IF = re.compile(r"^ {2,}(?:\} else )?if \((?P<condition>[^;{}\"\n]+)\)(?= \{$| [^\n]+;$|$)", re.M)
LOOP = re.compile(r"\bfor \((?:int|std::size_t|std::int(?:32|64)_t) \w+ = (?P<start>0);")
CARD = re.compile(r"\b\w+\.(?P<kind>number|integer)\((?P<field>\d+), \"[^\"]+\", (?P<default>-?[\d.]+)\)")
FIELD = re.compile(r"\b\w+\.(?:number|integer)\((?P<field>\d+), \"[^\"]+\"")
# Members of a state that is saved and read.
ARCHIVE = re.compile(r"\barchive\((?P<members>[^;{}()]+)\);")
DECIMAL = re.compile(r"(?<![\w.])\d+\.\d+(?:e-?\d+)?(?![\w.])")
NO_VALUE = re.compile(r"\[[&=\w, *]*\]\(|\[[&=]\]|fmt::|\bfail|std::move|co_|\bnew\b|//")
# Time that is measured, texts, and what is there for speed and memory alone, as no output tells.
NO_STATEMENT = re.compile(
    r"^(?:return|throw|delete|break|continue|static_assert|using|case|else|goto|ASSERT|EXPECT|#)\b|\b(?:reserve|shrink_to_fit|ahead|"
    r"PINBALL_\w+|prefetch|assert|fail\w*|throw|archive)\(|fmt::|//|\[[&=\w, *]*\]\(|\[[&=]\]")
TURNED = {" < ": " > ", " > ": " < ", " <= ": " > ", " >= ": " < ", " == ": " != ", " != ": " == ", " && ": " || ", " || ": " && "}
SIGNS = {" + ": " - ", " - ": " + ", "std::min(": "std::max(", "std::max(": "std::min(", "minimum(": "maximum(", "maximum(": "minimum("}
NEXT = {".x": ".y", ".y": ".z", ".z": ".x", "[0]": "[1]", "[1]": "[2]", "[2]": "[0]"}


def balanced(text):
    depth = 0
    for c in text:
        depth += (c in "([") - (c in ")]")
        if depth < 0 or (c == "," and depth == 0):
            return False
    return depth == 0


def replaced(text, table):
    """The text with one entry of the table in place of another, for each place where it may."""
    for old, new in table.items():
        for place in (m.start() for m in re.finditer(re.escape(old), text)):
            if old[0] in ".[" and text[place + len(old):place + len(old) + 1] in ("(", "_"):
                continue
            if re.match(r"\w", text[place + len(old):place + len(old) + 1]) and old[0] == ".":
                continue
            yield text[:place] + new + text[place + len(old):]


def of_values(file, text):
    for found in VALUE.finditer(text):
        value, begin = found["value"], found.start("value")
        if NO_VALUE.search(value) or not balanced(value) or re.fullmatch(r"[-\d.]+|true|false|nullptr", value):
            continue
        for rule, table in (("sign", SIGNS), ("index", NEXT), ("comparison", TURNED)):
            for wrong in replaced(value, table):
                yield Fault(file, value, wrong, rule=rule, begin=begin)
        kind = (found["type"] or "").removeprefix("const ")
        factor = {"double": "1.05", "float": "1.05F", "S": "static_cast<S>(1.05)", "T": "number<T>(1.05)"}.get(kind)
        if factor:
            yield Fault(file, value, f"{factor} * ({value})", rule="factor", begin=begin)
        for number in DECIMAL.finditer(value):
            yield Fault(file, number[0], repr(1.05 * float(number[0]) or 0.05), rule="factor", begin=begin + number.start())


def of_statements(file, text):
    for found in CALL_OR_ASSIGNMENT.finditer(text):
        statement = found["statement"]
        if not NO_STATEMENT.search(statement) and balanced(statement.rstrip(";").replace(", ", "")):
            yield Fault(file, statement, "", STATEMENT, "omitted", begin=found.start("statement"))
    for found in IF.finditer(text):
        condition = found["condition"]
        if re.search(r"(?<![=!<>])=(?!=)|\bauto\b", condition) or not balanced(condition.replace(", ", "")):
            continue
        yield Fault(file, condition, "false", rule="condition", begin=found.start("condition"))
        for wrong in replaced(condition, TURNED):
            yield Fault(file, condition, wrong, rule="comparison", begin=found.start("condition"))


def of_loops(file, text):
    for found in LOOP.finditer(text):
        yield Fault(file, "0", "1", rule="first", begin=found.start("start"))


def of_cards(file, text):
    for found in CARD.finditer(text):
        kind = "double" if found["kind"] == "number" else "std::int64_t"
        yield Fault(file, found[0], f"{kind}({found['default']})", rule="card", begin=found.start())
    for found in FIELD.finditer(text):
        yield Fault(file, found["field"], str(int(found["field"]) + 1), rule="field", begin=found.start("field"))


def of_archives(file, text):
    """A member that is saved, and not brought back by what goes on from that."""
    for found in ARCHIVE.finditer(text):
        begin = found.start("members")
        for part in found["members"].split(","):
            member = part.strip()
            yield Fault(file, member, f"::pinball_faults::unread({member})", rule="unread", begin=begin + part.index(member))
            begin += len(part) + 1


def in_a_constant(text, place):
    """Whether the place is in a line, or in a function, that the compiler works out, or beside the code: a comment, a macro."""
    line = text[text.rfind("\n", 0, place) + 1:place]
    if re.search(r"constexpr|consteval|static_assert|^\s*(//|#)|//", line):
        return True
    heads = [m for m in re.finditer(r"^(?! |}|\n|#|//)[^\n]*$", text[:place], re.M)]
    last = heads[-1][0] if heads else ""
    return "constexpr" in last or last.endswith("\\") or last.startswith("enum")


def candidates(file, text):
    """All faults that the rules know for a file."""
    found = [*of_values(file, text), *of_statements(file, text), *of_loops(file, text), *of_cards(file, text),
             *of_archives(file, text)]
    return [fault for fault in found if not in_a_constant(text, fault.begin) and fault.wrong != fault.right]
