"""Completion for bash and zsh offers what the program takes: verbs, options of each, scenes and keys.

    completion_test.py PROGRAM FOLDER       FOLDER: of the completions
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM, FOLDER = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])
BASH = """
source {script}
COMP_WORDS=({words})
COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1))
compopt() {{ :; }}
_pinball
printf '%s\\n' "${{COMPREPLY[@]}}"
"""
# The builtins of zsh's completion do nothing outside of it: what it is given to offer is printed instead.
ZSH = """
compadd() {{
  local suffix=''
  if [[ $1 == -S ]]; then suffix=$2; shift 2; fi
  if [[ $1 == -- ]]; then shift; fi
  for candidate in $@; do if [[ $candidate == ${{words[CURRENT]}}* ]]; then print -r -- $candidate$suffix; fi; done
}}
_files() {{ :; }}
words=({words})
CURRENT=$#words
source {script}
"""


def quoted(words):
    return " ".join(f"'{word}'" for word in words)


def bash(*words):
    return completions(["bash", "--norc", "-c", BASH.format(script=FOLDER / "pinball", words=quoted([PROGRAM, *words]))])


def zsh(*words):
    return completions(["zsh", "-f", "-c", ZSH.format(script=FOLDER / "_pinball", words=quoted([PROGRAM, *words]))])


def completions(command):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(command, check=True, capture_output=True, text=True, cwd=folder, stdin=subprocess.DEVNULL)
    assert not run.stderr, run.stderr
    return set(run.stdout.split())


def help_of(*verb):
    run = subprocess.run([PROGRAM, *verb, "--help"], capture_output=True, text=True)
    return run.stdout if run.returncode == 0 else ""  # a verb whose own program is not there


def verbs():
    return set(re.findall(r"^  ([a-z][a-z-]*)(?: |$)", help_of().split("Subcommands:")[1], re.M))


def options(verb):
    return set(re.findall(r"^  (?:-\w, ?)?(--[a-z-]+)", help_of(verb), re.M))


def check_options_are_taken(test, verb, offered):
    """An option that is unknown is named so."""
    for option in offered - {"--help"}:
        run = subprocess.run([PROGRAM, verb, option], capture_output=True, text=True)
        test.assertNotIn("not expected", run.stderr, option)


class Completion:
    def test_offers_all_verbs(self):
        self.assertGreaterEqual(verbs(), {"run", "info", "compare", "converge", "verify"})
        self.assertEqual(self.complete(""), verbs() | {"--help", "--version"})
        self.assertEqual(self.complete("ver"), {"verify"})

    def test_offers_all_options_of_each_verb(self):
        for verb in verbs():
            with self.subTest(verb):
                self.assertEqual(self.complete(verb, "--"), options(verb))
        self.assertIn("--checkpoint-every", self.complete("run", "--ch"))

    def test_offers_no_option_that_is_unknown(self):
        check_options_are_taken(self, "verify", self.complete("verify", "--"))

    def test_offers_choices(self):
        self.assertEqual(self.complete("run", "block", "--precision", ""), {"float", "double", "mixed"})
        self.assertEqual(self.complete("verify", "--device", ""), {"none", "mock", "cuda", "hip"})
        self.assertNotIn("mock", self.complete("info", "--device", ""))

    def test_offers_nothing_where_a_number_is_wanted(self):
        self.assertEqual(self.complete("run", "--threads", ""), set())

    def test_offers_all_scenes(self):
        scenes = {path.stem for path in (ROOT / "data/scenes").glob("*.toml")}
        for verb in ["run", "info", "compare", "converge", "verify"]:
            with self.subTest(verb):
                self.assertEqual(self.complete(verb, ""), scenes)
        self.assertEqual(self.complete("run", "--quiet", "rod_p"), {"rod_plate"})

    def test_offers_keys_that_the_program_knows(self):
        keys = self.complete("run", "block", "--set", "")
        self.assertGreaterEqual(keys, {"time.end=", "contact.friction=", "output.fields=", "precision="})
        for key in keys:
            run = subprocess.run([PROGRAM, "info", "block", "--set", key + "?"], capture_output=True, text=True)
            self.assertNotIn("unknown key", run.stderr)
        self.assertEqual(self.complete("compare", "block", "--vary", "contact.e"), {"contact.enforcement="})


class Bash(Completion, unittest.TestCase):
    complete = staticmethod(bash)


@unittest.skipUnless(shutil.which("zsh"), "there is no zsh")
class Zsh(Completion, unittest.TestCase):
    complete = staticmethod(zsh)


if __name__ == "__main__":
    os.environ["PATH"] = "/usr/bin:/bin"
    unittest.main(argv=sys.argv[:1])
