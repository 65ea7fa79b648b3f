"""Every header compiles alone and without a warning, also when it is included twice.

    headers_alone_test.py FOLDER COMPILER BUILD_FOLDER      compiled as BUILD_FOLDER compiles FOLDER/one_header.cpp; in
                                                            FOLDER it keeps what was right, which is not compiled again
    headers_alone_test.py FOLDER COMPILER BUILD_FOLDER each chain by itself, for all that is no word of a header

A header that includes A, and all that A includes, compiles after A as it does alone: it sees nothing that it does not
include. So headers are compiled in chains of such, the least number of them that has all (Dilworth). A source has as
many of these chains as have no words of each other (header_groups.py): most of the time goes into what all of them read.
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

import header_groups

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DIRECTIVE = re.compile(r'^[ \t]*#[ \t]*(if|endif|include[ \t]*[<"]([^>"]+)[>"])', re.M)
# Nearly all headers end up reading these, which takes most of the time. That a header forgets one of them is seen by
# standard_names.py.
COMMON = ["algorithm", "array", "functional", "map", "memory", "optional", "span", "string", "vector"]
COMMON_FILE, PACKS_FILE = "common.hxx", "packs.hxx"
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
    def __init__(self, tree, folder, command, each):
        self.headers, self.folder, self.command = Headers(tree), folder, [*command, f"-I{tree}", "-Werror"]
        self.each, self.precompiled = each, set()
        version = subprocess.run([command[0], "--version"], check=True, capture_output=True, text=True).stdout
        self.start = "\n".join([pathlib.Path(__file__).read_text(), version, *self.command])

    def has_packs(self, chain):
        return PACKS in self.headers.closure(chain[-1], False)

    def common_of(self, group):
        return PACKS_FILE if self.has_packs(group[0]) else COMMON_FILE

    def groups(self):
        """Lists of chains, each for one source."""
        chains = self.headers.chains()
        return [[chain] for chain in chains] if self.each else header_groups.groups_of(self.headers, chains, self.has_packs)

    def key(self, group):
        names = [name for chain in group for name in chain]
        read = sorted(set(names).union(*(self.headers.closure(chain[-1], False) for chain in group)))
        content = "".join((self.headers.tree / name).read_text() for name in read if (self.headers.tree / name).is_file())
        return hashlib.sha256((self.start + "\n".join(names) + content).encode()).hexdigest()

    def precompile(self, name, includes):
        path = self.folder / name
        path.write_text("".join(f"#include <{include}>\n" for include in includes))
        subprocess.run([*self.command, "-x", "c++-header", path, "-o", f"{path}.gch"], check=True)
        self.precompiled.add(name)

    def problem(self, group):
        """What the compiler says of chains in one source, or nothing."""
        text = "".join(2 * f"#include <{name}>\n" for chain in group for name in chain)
        common = self.folder / self.common_of(group)
        run = subprocess.run([*self.command, "-include", common, "-fsyntax-only", "-x", "c++", "-"], input=text,
                             capture_output=True, text=True)
        return run.stderr if run.returncode else ""

    def problems(self):
        right = self.folder / ("right_each" if self.each else "right")
        known = set(right.read_text().split()) if right.exists() else set()
        keys = {self.key(group): group for group in self.groups()}
        new = [key for key in keys if key not in known]
        for name, includes in {COMMON_FILE: COMMON, PACKS_FILE: [*COMMON, PACKS]}.items():
            if name not in self.precompiled and any(self.common_of(keys[key]) == name for key in new):
                self.precompile(name, includes)
        with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            said = dict(zip(new, pool.map(lambda key: self.problem(keys[key]), new)))
        right.write_text("".join(f"{key}\n" for key in keys if not said.get(key)))
        return [text for text in said.values() if text]


class HeadersAlone(unittest.TestCase):
    def test_all_compile(self):
        folder, build = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[3])
        command = command_of(sys.argv[2], build, folder / "one_header.cpp")
        self.assertEqual("\n".join(Compiler(ROOT, folder, command, "each" in sys.argv[4:]).problems()), "")

    def test_each_is_in_a_chain_once(self):
        headers = Headers(ROOT)
        self.assertEqual(sorted(name for chain in headers.chains() for name in chain), headers.names)
        self.assertGreater(len(headers.names), 500)

    def test_groups_have_each_chain_once(self):
        headers = Headers(ROOT)
        groups = header_groups.groups_of(headers, headers.chains(), lambda chain: PACKS in headers.closure(chain[-1], False))
        self.assertEqual(sorted(chain for group in groups for chain in group), headers.chains())
        self.assertLess(len(groups), len(headers.chains()) / 2)

    def test_finds_what_is_planted(self):
        """A header that takes what another includes, or what is included for some alone; and one that defines twice."""
        planted = {
            "a": "#pragma once\nstruct Alpha {};\n",
            "b": '#pragma once\n#include "a.hpp"\nstruct Beta : Alpha {};\n',
            "c": '#pragma once\n#include "a.hpp"\n#include "b.hpp"\nstruct Gamma : Beta {};\n'
                 "#define MACRO_OF_C 1\ninline int function_of_c(int a) { return a; }\n"
                 "inline Alpha operator+(Alpha a, Alpha) { return a; }\n",
            "d": "#pragma once\nstruct Delta {};\n",
            "no_include": '#pragma once\n#include "a.hpp"\nstruct NoInclude : Beta {};\n',
            "for_some": '#pragma once\n#include "a.hpp"\n#ifdef FOR_SOME\n#include "b.hpp"\n#endif\nstruct ForSome : Beta {};\n',
            "no_function": '#pragma once\n#include "a.hpp"\ninline int no_function() { return function_of_c(1); }\n',
            "no_macro": "#pragma once\ninline int no_macro() { return MACRO_OF_C; }\n",
            "no_operator": '#pragma once\n#include "a.hpp"\ninline Alpha no_operator() { return Alpha{} + Alpha{}; }\n',
            "no_guard": "struct NoGuard {};\n",
            "warns": "#pragma once\ninline int warns(int number) { return 0; }\n",
        }
        with tempfile.TemporaryDirectory() as folder:
            tree = pathlib.Path(folder) / "tree"
            (tree / "kernels").mkdir(parents=True)
            for name, text in planted.items():
                (tree / "kernels" / f"{name}.hpp").write_text(text)
            command = [sys.argv[2], "-std=c++20", "-Wall", "-Wextra"]
            expected = {"no_include", "for_some", "no_function", "no_macro", "no_operator", "no_guard", "warns"}
            for each in (False, True):
                compiler = Compiler(tree, pathlib.Path(folder), command, each)
                for _ in range(2):  # what was wrong is compiled again
                    wrong = {name for text in compiler.problems() for name in planted if f"kernels/{name}.hpp:" in text}
                    self.assertEqual(wrong, expected)
            self.assertTrue(any(len(group) > 1 for group in Compiler(tree, pathlib.Path(folder), command, False).groups()))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
