"""What the tests of the commands in bench/ have in common."""

import csv
import importlib.machinery
import importlib.util
import os
import subprocess

BENCH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench")


def load_command(name):
    """A command of bench/ as a module."""
    loader = importlib.machinery.SourceFileLoader(name, os.path.join(BENCH, name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def rows_of(folder, name):
    """Rows of a CSV file, by the names of its columns."""
    with open(os.path.join(folder, name), newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Calls:
    """To be mixed into a unittest.TestCase. command: path of the program."""

    command = ""

    def call(self, *arguments):
        return subprocess.run([self.command, *arguments], capture_output=True, text=True)

    def test_help(self):
        done = self.call("--help")
        self.assertEqual(done.returncode, 0)
        self.assertIn("--quick", done.stdout)
