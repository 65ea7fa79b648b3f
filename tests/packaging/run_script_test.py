"""./run in a tree of this test, whose program only notes how it was called."""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

COMMAND = pathlib.Path(__file__).resolve().parent.parent.parent / "run"
PINBALL = """#!/bin/sh
echo "$@" >> "$HERE/calls"
env > "$HERE/environment of $1"
case $1 in run) mkdir -p "$HERE/tree/out/balls" && touch "$HERE/tree/out/balls/index.html" ;; esac
"""


class Run(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        tree = self.folder / "tree"
        (tree / "build/release").mkdir(parents=True)
        (tree / "cmake").mkdir()
        (tree / "home").mkdir()
        shutil.copy(COMMAND, tree)
        programs = {"build/release/pinball": PINBALL, "cmake/install-packages": "#!/bin/sh\n", "cmake/build-release": "#!/bin/sh\n"}
        for name, text in programs.items():
            (tree / name).write_text(text)
            (tree / name).chmod(0o755)
        self.tree = tree

    def test_what_drawing_keeps_stays_in_the_tree(self):
        environment = {"PATH": "/usr/bin:/bin", "HERE": str(self.folder), "HOME": str(self.tree / "home")}
        done = subprocess.run([self.tree / "run", "balls"], capture_output=True, text=True, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("index.html", done.stdout)
        run, view = (self.folder / "calls").read_text().splitlines()
        self.assertEqual((run, view.split()[0]), (f"run balls --out {self.tree}/out/balls", "view"))
        drawn_in = dict(line.split("=", 1) for line in (self.folder / "environment of view").read_text().splitlines())
        self.assertTrue(os.path.isdir(drawn_in["MPLCONFIGDIR"]))
        self.assertTrue(drawn_in["MPLCONFIGDIR"].startswith(f"{self.tree}/build/"))
        self.assertEqual(drawn_in["MESA_SHADER_CACHE_DISABLE"], "true")


if __name__ == "__main__":
    unittest.main()
