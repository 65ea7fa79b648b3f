"""Every header compiles alone and without a warning, also when it is included twice.

    headers_alone_test.py FOLDER COMPILER BUILD_FOLDER      compiled as BUILD_FOLDER compiles FOLDER/one_header.cpp; in
                                                            FOLDER it keeps what was right, which is not compiled again

A header that includes A, and all that A includes, compiles after A as it does alone: it sees nothing that it does not
include. So headers are compiled in chains of such, the least number of them that has all (Dilworth).
"""

import concurrent.futures
import hashlib
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DIRECTIVE = re.compile(r'^[ \t]*#[ \t]*(if|endif|include[ \t]*[<"]([^>"]+)[>"])', re.M)
# Nearly all headers end up reading these, which takes most of the time. That a header forgets one of them is seen by
# standard_names.py.
COMMON = ["algorithm", "array", "functional", "map", "memory", "optional", "span", "string", "vector"]
PACKS = "experimental/simd"  # as long to read as all others, and read by few


class Headers:
    """What each header of a tree includes."""

    def __init__(self, tree):
        self.tree = tree
        self.names = sorted(str(path.relative_to(tree)) for folder in ["kernels", "solver"] for path in (tree / folder).rglob("*.hpp"))
        self.known = {}

    def included_by(self, name):
        """Files, or names of other headers, each with whether it is included in any case."""
        path, depth = self.tree / name, 0
        for match in DIRECTIVE.finditer(path.read_text() if path.is_file() else ""):
            depth += {"if": 1, "endif": -1}.get(match[1], 0)
            if match[2]:
                beside = pathlib.Path(os.path.normpath(path.parent / match[2]))
                yield str(beside.relative_to(self.tree)) if beside.is_file() else match[2], depth == 0

    def closure(self, name, surely):
        """All that it includes, and that these include: in any case, or where conditions are met, too."""
        if (name, surely) not in self.known:
            self.known[name, surely] = found = set()
            for other, always in self.included_by(name):
                if always or not surely:
                    found |= {other} | self.closure(other, surely)
        return self.known[name, surely]

    def chains(self):
        """Each header includes the one before it in any case, and so all that this one includes: a matching without
        augmenting paths."""
        after = {name: [] for name in self.names}
        for name in sorted(self.names, key=lambda name: len(self.closure(name, True))):
            for other in self.closure(name, True) & set(self.names):
                after[other].append(name)
        before = {}

        def find(name, tried):
            for other in after[name]:
                if other not in tried:
                    tried.add(other)
                    if other not in before or find(before[other], tried):
                        before[other] = name
                        return True
            return False

        for name in self.names:
            find(name, set())
        chains = []
        for last in set(self.names) - set(before.values()):
            chain = [last]
            while chain[-1] in before:
                chain.append(before[chain[-1]])
            chains.append(chain[::-1])
        return sorted(chains)


def command_of(compiler, build, source):
    """The words before the name of the output."""
    with open(build / "compile_commands.json", encoding="utf-8") as file:
        words, = (shlex.split(entry["command"]) for entry in json.load(file) if entry["file"] == str(source))
    return words[words.index(compiler):words.index("-o")]


class Compiler:
    def __init__(self, tree, folder, command):
        self.headers, self.folder, self.command = Headers(tree), folder, [*command, f"-I{tree}", "-Werror"]
        version = subprocess.run([command[0], "--version"], check=True, capture_output=True, text=True).stdout
        self.start = "\n".join([pathlib.Path(__file__).read_text(), version, *self.command])

    def key(self, chain):
        read = sorted(set(chain) | self.headers.closure(chain[-1], False))
        content = "".join((self.headers.tree / name).read_text() for name in read if (self.headers.tree / name).is_file())
        return hashlib.sha256((self.start + "\n".join(chain) + content).encode()).hexdigest()

    def precompile(self, name, includes):
        path = self.folder / name
        path.write_text("".join(f"#include <{include}>\n" for include in includes))
        subprocess.run([*self.command, "-x", "c++-header", path, "-o", f"{path}.gch"], check=True)

    def problem(self, chain):
        """What the compiler says of a chain, or nothing."""
        common = "packs.hxx" if PACKS in self.headers.closure(chain[-1], False) else "common.hxx"
        text = "".join(2 * f"#include <{name}>\n" for name in chain)
        run = subprocess.run([*self.command, "-include", self.folder / common, "-fsyntax-only", "-x", "c++", "-"], input=text,
                             capture_output=True, text=True)
        return run.stderr if run.returncode else ""

    def problems(self):
        right = self.folder / "right"
        known = set(right.read_text().split()) if right.exists() else set()
        keys = {self.key(chain): chain for chain in self.headers.chains()}
        new = [key for key in keys if key not in known]
        if new:
            self.precompile("common.hxx", COMMON)
            self.precompile("packs.hxx", [*COMMON, PACKS])
        with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            said = dict(zip(new, pool.map(lambda key: self.problem(keys[key]), new)))
        right.write_text("".join(f"{key}\n" for key in keys if not said.get(key)))
        return [text for text in said.values() if text]


class HeadersAlone(unittest.TestCase):
    def test_all_compile(self):
        folder, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[3])
        command = command_of(sys.argv[2], build, folder / "one_header.cpp")
        self.assertEqual("\n".join(Compiler(ROOT, folder, command).problems()), "")

    def test_each_is_in_a_chain_once(self):
        headers = Headers(ROOT)
        self.assertEqual(sorted(name for chain in headers.chains() for name in chain), headers.names)
        self.assertGreater(len(headers.names), 500)

    def test_finds_what_is_planted(self):
        """A header that takes what another includes, or what is included for some alone; and one that defines twice."""
        planted = {
            "a": "#pragma once\nstruct A {};\n",
            "b": '#pragma once\n#include "a.hpp"\nstruct B : A {};\n',
            "c": '#pragma once\n#include "a.hpp"\n#include "b.hpp"\nstruct C : B {};\n',
            "no_include": '#pragma once\n#include "a.hpp"\nstruct NoInclude : B {};\n',
            "for_some": '#pragma once\n#include "a.hpp"\n#ifdef FOR_SOME\n#include "b.hpp"\n#endif\nstruct ForSome : B {};\n',
            "no_guard": "struct NoGuard {};\n",
            "warns": "#pragma once\ninline int warns(int number) { return 0; }\n",
        }
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder) / "tree"
            (tree / "kernels").mkdir(parents=True)
            for name, text in planted.items():
                (tree / "kernels" / f"{name}.hpp").write_text(text)
            compiler = Compiler(tree, pathlib.Path(folder), [sys.argv[2], "-std=c++20", "-Wall", "-Wextra"])
            for _ in range(2):  # what was wrong is compiled again
                wrong = {name for text in compiler.problems() for name in planted if f"kernels/{name}.hpp:" in text}
                self.assertEqual(wrong, {"no_include", "for_some", "no_guard", "warns"})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
