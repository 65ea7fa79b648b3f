"""Which headers may be compiled in one source, and are still seen to compile alone.

What a header forgets to include is missed where another before it has included it. So a header may come after others only if
it has no word that one of them declares and that is not in what it includes itself. Words are compared, not what they mean:
two that have nothing to do with each other keep headers apart, which costs time alone. What has no name, an operator or a
specialization, goes by the types that it is for. That a type is used which is only reached, and nowhere named, is not seen:
each chain by itself shows it.
"""

import re

IGNORED = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:[^"\\\n]|\\.)*"', re.S)
PARAMETERS = re.compile(r"\btemplate <[^;{]*?>(?=\n|\s+(?:class|struct|using|inline|constexpr|auto|void))")
WORD = re.compile(r"\b[A-Za-z_]\w+")  # of a letter alone: parameters of templates, and of functions
TYPE = re.compile(r"\b(?:struct|class|enum|union|concept|using|namespace)\s+(\w+)")
MACRO = re.compile(r"#\s*define\s+(\w+)")
AT_NAMESPACE = re.compile(r"^[^\s#}].*", re.M)
NAMED = re.compile(r"\b([A-Za-z_]\w+)\s*(?:[(={\[;]|$)")
OPERATOR = re.compile(r"^\S.*\boperator\b.*", re.M)
SPECIALIZED = re.compile(r"^template <>\n(.*)", re.M)
# Of the language and of the standard library, whose names standard_names.py looks after.
OF_ALL = set("""alignas alignof auto bool char class const constexpr decltype default double enum explicit extern false float if
    inline int namespace noexcept operator private public requires return sizeof static struct template true typename union
    unsigned using void array filesystem function int32_t int64_t map optional path pinball size_t span std string string_view
    uint8_t uint32_t uint64_t vector""".split())


class Words:
    """Of the headers of a tree: the words that each has, and those that it declares."""

    def __init__(self, headers):
        self.headers = headers
        self.used, self.declared = {}, {}
        for name in headers.names:
            text = PARAMETERS.sub("template ", IGNORED.sub("", (headers.tree / name).read_text()))
            self.used[name] = set(WORD.findall(text))
            found = set(TYPE.findall(text)) | set(MACRO.findall(text))
            for line in AT_NAMESPACE.findall(text):
                found.update(NAMED.findall(line))
            for line in OPERATOR.findall(text) + SPECIALIZED.findall(text):
                found.update(WORD.findall(line))
            self.declared[name] = found - OF_ALL

    def declared_by(self, name):
        """A header of another library by the folder that it is in, which is also the name of its namespace."""
        if name in self.declared:
            return self.declared[name]
        return set(WORD.findall(name.split("/")[0])) if "/" in name else set()

    def may_follow(self, chain, seen):
        """Whether a chain of headers may come after those that a source has seen."""
        for name in chain:
            own = self.headers.closure(name, True) | {name}
            if any(self.declared_by(other) & self.used[name] for other in seen - own):
                return False
        return True


def groups_of(headers, chains, kind_of):
    """Lists of chains, each for one source; those of one have the same kind."""
    words, groups = Words(headers), []
    for chain in sorted(chains, key=lambda chain: (-len(headers.closure(chain[-1], False)), chain)):
        for kind, seen, together in groups:
            if kind == kind_of(chain) and words.may_follow(chain, seen):
                break
        else:
            kind, seen, together = kind_of(chain), set(), []
            groups.append((kind, seen, together))
        seen |= headers.closure(chain[-1], False) | set(chain)
        together.append(chain)
    return [together for _, _, together in groups]
