"""The manual page has the verbs and options that the program has, and is laid out without a complaint.

    manual_test.py PROGRAM
"""

import pathlib
import re
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PAGE = ROOT / "docs" / "pinball.1"
PROGRAM = None
SECTION = re.compile(r"^\.Ss ([a-z, ]+)\n(.*?)(?=^\.S[sh] )", re.M | re.S)


def help_of(*verb):
    run = subprocess.run([PROGRAM, *verb, "--help"], capture_output=True, text=True)
    return run.stdout if run.returncode == 0 else ""


def options_of_page(text):
    """Options of each verb, as the page has them."""
    found = {}
    for verbs, section in SECTION.findall(text):
        options = {word for line in re.findall(r"^\.It (Fl .*)$", section, re.M) for word in re.findall(r"Fl -([a-z-]+)", line)}
        for verb in verbs.split(", "):
            found.setdefault(verb, set()).update(options)
    return found


def options_of_program():
    verbs = re.findall(r"^  ([a-z][a-z-]*)(?: |$)", help_of().split("Subcommands:")[1], re.M)
    return {verb: set(re.findall(r"^  (?:-\w, ?)?--([a-z-]+)", help_of(verb), re.M)) - {"help"} for verb in verbs}


class Manual(unittest.TestCase):
    text = PAGE.read_text()

    def test_has_the_verbs_and_options_of_the_program(self):
        of_page, of_program = options_of_page(self.text), options_of_program()
        self.assertEqual(set(of_page), set(of_program))
        for verb, options in of_program.items():
            if help_of(verb):  # else what it starts is not there to be asked
                with self.subTest(verb):
                    self.assertEqual(of_page[verb], options)

    def test_shows_each_verb_in_the_synopsis(self):
        synopsis = self.text.split(".Sh SYNOPSIS")[1].split(".Sh ")[0]
        self.assertEqual(set(re.findall(r"^\.Cm ([a-z]+)$", synopsis, re.M)), set(options_of_program()))

    def test_finds_a_difference(self):
        self.assertNotIn("quiet", options_of_page(self.text.replace(".It Fl -quiet", ".It Fl -silent"))["run"])

    @unittest.skipUnless(shutil.which("man") and shutil.which("groff"), "there is no man")
    def test_is_laid_out_without_a_complaint(self):
        run = subprocess.run(["man", "--warnings", "-l", PAGE], capture_output=True, text=True,
                             env={"PATH": "/usr/bin:/bin", "LC_ALL": "C.UTF-8", "MANWIDTH": "100"}, check=True)
        self.assertEqual(run.stderr, "")
        self.assertIn("--checkpoint-every", run.stdout)


if __name__ == "__main__":
    PROGRAM = sys.argv.pop(1)
    unittest.main()
