"""The sources of the library and of the program compile with Clang as a configuration of its own compiles them; no code is
made of them.

    clang_test.py CMAKE CLANG FOLDER      FOLDER: the configuration is made there
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def commands(folder):
    """The commands of all units, without what is read precompiled, which is made by building."""
    for entry in json.loads((folder / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        if entry["file"].endswith((".hxx", ".hxx.cxx", ".c")):
            continue
        while "-Xclang" in words:
            at = words.index("-Xclang")
            del words[at:at + 2]
        output = words.index("-o")
        yield entry["file"], [*words[:output], "-fsyntax-only", *words[output + 2:]], entry["directory"]


class WithClang(unittest.TestCase):
    def setUp(self):
        cmake, clang, self.folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
        shutil.rmtree(self.folder, ignore_errors=True)
        c = re.sub(r"clang\+\+", "clang", clang)
        run = subprocess.run([cmake, "--preset", "release", "-B", self.folder, f"-DCMAKE_CXX_COMPILER={clang}",
                              f"-DCMAKE_C_COMPILER={c}", "-DPINBALL_TESTS=OFF", "-DPINBALL_BENCH=OFF", "-DPINBALL_PYTHON=OFF"],
                             cwd=ROOT, capture_output=True, text=True)
        if "Could NOT find OpenMP" in run.stdout + run.stderr:
            self.skipTest("there is no OpenMP for Clang (Debian: libomp-14-dev)")
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def test_all_units_compile(self):
        units = list(commands(self.folder))
        self.assertGreater(len(units), 60)

        def problem(unit):
            file, words, directory = unit
            run = subprocess.run(words, cwd=directory, capture_output=True, text=True)
            return f"{file}: {run.stderr}" if run.returncode else ""

        with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
            self.assertEqual("\n".join(filter(None, pool.map(problem, units))), "")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
