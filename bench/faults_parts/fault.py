"""A fault: a piece of a source text and what is to stand there instead."""

import hashlib
import os
from dataclasses import dataclass

EXPRESSION, STATEMENT = "expression", "statement"


@dataclass(frozen=True)
class Fault:
    file: str  # below the root of the tree
    right: str  # the text as it stands there, once
    wrong: str  # of a statement that is left out: nothing
    form: str = EXPRESSION
    rule: str = "named"
    what: str = ""  # a fault in words, where it was named
    begin: int = -1  # place of the text in the file, where a rule has found it

    @property
    def room(self):
        parts = os.path.dirname(self.file).split("/")
        return parts[0] if parts[0] == "kernels" or len(parts) == 1 else parts[1]

    @property
    def name(self):
        """The same as long as the text is, wherever it stands."""
        text = f"{self.file}\n{self.rule}\n{self.right}\n{self.wrong}"
        return f"{os.path.basename(self.file)}:{hashlib.sha1(text.encode()).hexdigest()[:8]}"

    def described(self):
        if self.what:
            return self.what
        one_line = " ".join(self.right.split())
        return f"`{one_line}` " + ("left out" if not self.wrong else f"-> `{' '.join(self.wrong.split())}`")

    def planted(self, number):
        """The text with a switch, of as many lines."""
        switch = f"::pinball_faults::on({number})"
        if self.form == EXPRESSION:
            text = f"({switch} ? ({joined(self.wrong)}) : ({joined(self.right)}))"
        elif self.wrong:
            text = f"{{ if ({switch}) {{ {joined(self.wrong)} }} else {{ {joined(self.right)} }} }}"
        else:
            text = f"{{ if (!{switch}) {{ {joined(self.right)} }} }}"
        return text + "\n" * self.right.count("\n")


def joined(text):
    return " ".join(text.split())
