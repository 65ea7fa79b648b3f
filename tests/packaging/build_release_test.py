"""cmake/build-release with a cmake of this test: what it builds anew, and with which options."""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

COMMAND = pathlib.Path(__file__).resolve().parent.parent.parent / "cmake/build-release"

CMAKE = """#!/bin/sh
echo "$@" >> calls
case $1 in --preset)
  mkdir -p build/release
  touch build/release/build.ninja
  echo "CMAKE_HOME_DIRECTORY:INTERNAL=$(pwd -P)" > build/release/CMakeCache.txt ;;
esac
"""


class BuildRelease(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.tree = self.make_tree("tree")

    def make_tree(self, name):
        tree = self.folder / name
        (tree / "cmake").mkdir(parents=True)
        shutil.copy(COMMAND, tree / "cmake")
        (tree / "bin").mkdir()
        (tree / "bin/cmake").write_text(CMAKE)
        (tree / "bin/cmake").chmod(0o755)
        return tree

    def build(self, tree, target="installable"):
        done = subprocess.run([tree / "cmake/build-release", target], capture_output=True, text=True,
                              env={"PATH": f"{tree}/bin:/usr/bin:/bin"})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        calls = (tree / "calls").read_text().splitlines()
        (tree / "calls").unlink()
        return done.stdout, calls

    def test_configures_once_and_builds_each_time(self):
        said, calls = self.build(self.tree)
        self.assertEqual(len(calls), 2)
        self.assertIn("-DPINBALL_TESTS=OFF", calls[0])
        (self.tree / "build/release/object").write_text("")
        said, calls = self.build(self.tree)
        self.assertEqual(calls, ["--build --preset release --target installable"])
        self.assertNotIn("anew", said)
        self.assertTrue((self.tree / "build/release/object").exists())

    def test_a_moved_tree_is_built_anew(self):
        self.build(self.tree)
        (self.tree / "build/release/object").write_text("")
        moved = self.tree.rename(self.folder / "a tree that was moved")
        said, calls = self.build(moved)
        self.assertIn(f"This tree was built in {self.tree}: building anew", said)
        self.assertIn("--preset release", calls[0])
        self.assertFalse((moved / "build/release/object").exists())

    def test_a_copied_tree_is_built_anew_and_the_first_is_left_alone(self):
        self.build(self.tree)
        (self.tree / "build/release/object").write_text("")
        copy = pathlib.Path(shutil.copytree(self.tree, self.folder / "copy"))
        self.build(copy)
        self.assertFalse((copy / "build/release/object").exists())
        self.assertTrue((self.tree / "build/release/object").exists())

    def test_a_tree_by_another_name_is_not(self):
        self.build(self.tree)
        (self.tree / "build/release/object").write_text("")
        link = self.folder / "link"
        link.symlink_to(self.tree)
        said, calls = self.build(link)
        self.assertNotIn("anew", said)
        self.assertTrue((self.tree / "build/release/object").exists())


if __name__ == "__main__":
    unittest.main()
