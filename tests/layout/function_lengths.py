"""How long functions of the kernels are: from the first line of the declaration to the closing brace.

    function_lengths.py [TREE]      prints every function of kernels/ that has more than 80 lines; exit status 1 if one has

A lambda is part of the function that it stands in.
"""

import pathlib
import re
import sys

import checked_tree

MOST = 80

COMMENT_OR_TEXT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n\\]|\\.|\\\n)*", re.M)
TEMPLATE = re.compile(r"\s*(template\s*<|requires\b)")
NOT_FUNCTION = re.compile(r"(inline\s+)?(namespace|struct|class|union|enum|extern)\b")
OF_REQUIRES = re.compile(r"\brequires\s*(\([^()]*\))?$")
BEFORE_BODY = re.compile(r"(\)|\}|\bconst|\bnoexcept|\boverride|\bfinal|\bmutable|->[^()]*)$")


def blanked(text):
    """The text without comments, literals and directives; lines stay where they are."""
    def blank(found):
        return re.sub(r"[^\n]", " ", found.group())
    return DIRECTIVE.sub(blank, COMMENT_OR_TEXT.sub(blank, text))


def end_of_block(text, opening):
    depth = 0
    for at in range(opening, len(text)):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return at
    raise ValueError("a brace is open at the end")


def without_template(head):
    """What follows template <...> and its requires."""
    while TEMPLATE.match(head):
        head = head.lstrip()
        if head.startswith("requires"):
            return re.sub(r"^.*?\}", "", head, flags=re.S) if "}" in head else head
        depth = 0
        for at, letter in enumerate(head):
            depth += {"<": 1, ">": -1}.get(letter, 0)
            if letter == ">" and depth == 0:
                head = head[at + 1:]
                break
        else:
            return head
    return head.strip()


def functions(text):
    """(name, first line, number of lines) of each function with a body."""
    text = blanked(text)
    begin, at = 0, 0
    while at < len(text):
        letter = text[at]
        if letter in ";}":
            begin = at + 1
        elif letter == "{":
            head = text[begin:at].rstrip()
            own = without_template(head)
            if OF_REQUIRES.search(own):
                at = end_of_block(text, at)  # of a requires-expression: the declaration goes on
            elif NOT_FUNCTION.match(own):
                begin = at + 1
            elif "(" in own and BEFORE_BODY.search(own):
                end = end_of_block(text, at)
                first = begin + len(head) - len(head.lstrip())
                name = re.search(r"([\w~]+|operator\s*\S+?)\s*\(", re.sub(r"^(\[\[.*?\]\]|\s|PINBALL_\w+)*", "", own))
                yield name.group(1), text.count("\n", 0, first) + 1, text.count("\n", first, end) + 1
                begin, at = end + 1, end
            else:
                at = end_of_block(text, at)  # an initializer
        at += 1


def too_long(tree, most=MOST):
    """path:line: name has so many lines."""
    tree = pathlib.Path(tree)
    found = []
    for file in sorted((tree / "kernels").rglob("*.hpp")):
        for name, line, lines in functions(file.read_text()):
            if lines > most:
                found.append(f"{file.relative_to(tree)}:{line}: {name} has {lines} lines")
    return found


if __name__ == "__main__":
    sys.exit(checked_tree.print_problems(too_long(checked_tree.chosen()), f"no function of kernels/ has more than {MOST} lines"))
