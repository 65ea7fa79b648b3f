"""cmake/install-packages with a dpkg and an apt-get of this test: what it asks them for, and what it says of that."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

COMMAND = pathlib.Path(__file__).resolve().parent.parent.parent / "cmake/install-packages"

# Of files beside them: the packages that are there, what apt-get answers to `install`, and what it was called with.
PROGRAMS = {
    "id": "echo 0",
    "date": 'n=$(cat "$HERE/seconds"); echo $((n + 4)) | tee "$HERE/seconds"',
    "dpkg-query": 'sed "s/^/ii  /" "$HERE/there"; echo "rc  removed-package"; echo "un  xvfb"',
    "apt-get": 'echo "$@" >> "$HERE/calls"; case "$*" in *" install "*) sh "$HERE/install" ;; *) sh "$HERE/update" ;; esac',
}


class InstallPackages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        for name, text in PROGRAMS.items():
            (self.folder / name).write_text(f"#!/bin/sh\n{text}\n")
            (self.folder / name).chmod(0o755)
        for name, text in {"seconds": "1000", "there": "", "calls": "", "install": "", "update": ""}.items():
            (self.folder / name).write_text(text)
        (self.folder / "there").write_text("\n".join(self.all_packages()) + "\n")

    asked = []

    def all_packages(self):
        """The first of each choice, as the command asks for them where nothing is there."""
        if not self.asked:
            self.run_command()
            self.asked.extend(self.calls()[-1].split("--no-remove ")[1].split())
            (self.folder / "calls").write_text("")
        return self.asked

    def run_command(self, what="running", *packages, status=0):
        done = subprocess.run([COMMAND, what, *packages], capture_output=True, text=True, env={
            "PATH": f"{self.folder}:/usr/bin:/bin", "HERE": str(self.folder), "TMPDIR": str(self.folder)})
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def calls(self):
        return (self.folder / "calls").read_text().splitlines()

    def without(self, *packages, instead=()):
        there = (self.folder / "there").read_text().split()
        (self.folder / "there").write_text("\n".join([p for p in there if p not in packages] + list(instead)) + "\n")

    def test_does_nothing_where_all_is_there(self):
        done = self.run_command()
        self.assertEqual((done.stdout, done.stderr, self.calls()), ("", "", []))

    def test_asks_for_what_is_missing_and_removes_nothing(self):
        self.without("ninja-build", "xvfb")
        self.run_command("running", "clang-format-14")
        update, install = self.calls()
        self.assertIn("update", update)
        self.assertRegex(install, r"install --no-install-recommends --no-remove ninja-build xvfb clang-format-14$")

    def test_takes_vtk_of_paraview_where_that_is_there(self):
        self.without("python3-vtk9", instead=["python3-paraview"])
        self.run_command()
        self.assertEqual(self.calls(), [])
        self.without("python3-paraview")
        self.run_command()
        self.assertRegex(self.calls()[-1], "--no-remove python3-vtk9$")

    def test_tests_ask_for_more(self):
        self.run_command("testing")
        asked = self.calls()[-1].split("--no-remove ")[1].split()
        self.assertTrue({"git", "libgtest-dev", "chromium", "zsh"} <= set(asked), asked)

    def test_says_what_comes_and_how_far_it_is(self):
        self.without("xvfb")
        (self.folder / "install").write_text("""
            echo 'Need to get 317 MB of archives.'
            for percent in 1.5 20.25 40.5 60 80 99; do echo "dlstatus:7:$percent:Retrieving file 7 of 183"; done
            echo 'Selecting previously unselected package xvfb.'
            for percent in 1.5 20.25 40.5 60 80; do echo "pmstatus:xvfb:$percent:Unpacking xvfb (amd64)"; done
        """)
        said = self.run_command().stdout.splitlines()
        self.assertEqual(said[:2], ["Installing xvfb", "  Need to get 317 MB of archives."])
        for doing in ("downloading", "installing"):
            percents = [int(m[1]) for m in (re.fullmatch(rf"{doing} packages: (\d+) %", line) for line in said) if m]
            self.assertTrue(percents and percents == sorted(percents), said)
        self.assertLess(len(said), 8)

    def test_says_in_one_line_that_there_is_no_network(self):
        self.without("xvfb")
        for name in ("update", "install"):
            (self.folder / name).write_text("""
                echo "Err:1 http://deb.debian.org/debian bookworm InRelease"
                echo "  Temporary failure resolving 'deb.debian.org'"
                echo "E: Unable to locate package xvfb"
                exit 100
            """)
        done = self.run_command(status=1)
        self.assertEqual(done.stderr, "No network (Temporary failure resolving 'deb.debian.org'): these packages are missing and "
                                      "cannot be fetched: apt-get install xvfb\n")

    def test_goes_on_with_lists_that_are_out_of_reach(self):
        self.without("xvfb")
        (self.folder / "update").write_text("echo \"Temporary failure resolving 'deb.debian.org'\"; exit 100")
        self.run_command()

    def test_says_what_would_be_removed(self):
        self.without("xvfb")
        (self.folder / "install").write_text("""
            echo "The following packages will be REMOVED:"
            echo "  python3-other"
            echo "The following NEW packages will be installed:"
            echo "  xvfb"
            echo "0 upgraded, 1 newly installed, 1 to remove and 3 not upgraded."
            echo "E: Packages need to be removed but remove is disabled."
            exit 100
        """)
        said = self.run_command(status=1).stderr.splitlines()
        self.assertEqual(said[0], "  python3-other")
        self.assertEqual(len(said), 2)
        self.assertIn("nothing was installed", said[1])

    def test_leaves_nothing_behind(self):
        self.without("xvfb")
        before = set(os.listdir(self.folder))
        self.run_command()
        self.assertEqual(set(os.listdir(self.folder)), before)


if __name__ == "__main__":
    unittest.main()
