"""The version stands in solver/base/version.h; what cannot be derived from it agrees, and the program says it.

    version_test.py PROGRAM
"""

import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
HEADER = (ROOT / "solver/base/version.h").read_text()
VERSION = ".".join(re.search(rf"#define PINBALL_VERSION_{part} (\d+)", HEADER)[1] for part in ["MAJOR", "MINOR", "PATCH"])
MINOR = VERSION.rsplit(".", 1)[0]
# Where else it stands, and how it is written there.
PLACES = {
    "CITATION.cff": r"^version: (\S+)$",
    "docs/pinball.1": r'^\.Os "Pinball ([^"]+)"',
    "packaging/conda/meta.yaml": r'^{% set version = "([^"]+)" %}',
    "CHANGELOG.md": r"^## \[(\d[^]]*)\]",  # the first of them: the latest
}
MINOR_PLACES = {"docs/embedding.md": r"find_package\(Pinball (\d\S*)", "docs/solver_library.md": r"find_package\(Pinball (\d\S+)",
                "tests/embedding/installed_hosts/CMakeLists.txt": r"find_package\(Pinball (\d\S*)"}


class Version(unittest.TestCase):
    program = None

    def test_is_the_same_everywhere(self):
        for place, pattern in PLACES.items():
            with self.subTest(place):
                self.assertEqual(re.findall(pattern, (ROOT / place).read_text(), re.M)[:1], [VERSION])

    def test_is_compatible_with_what_hosts_ask_for(self):
        asked = {place: set(re.findall(pattern, (ROOT / place).read_text())) for place, pattern in MINOR_PLACES.items()}
        self.assertTrue(any(asked.values()))
        for place, versions in asked.items():
            with self.subTest(place):
                self.assertLessEqual(versions, {MINOR})

    def test_is_what_the_program_says(self):
        said = subprocess.run([self.program, "--version"], check=True, capture_output=True, text=True).stdout
        self.assertEqual(said, f"pinball {VERSION}\n")


class Changelog(unittest.TestCase):
    text = (ROOT / "CHANGELOG.md").read_text()

    def test_has_the_form_of_keep_a_changelog(self):
        sections = re.findall(r"^## (.*)$", self.text, re.M)
        self.assertEqual(sections[0], "[Unreleased]")
        for section in sections[1:]:
            self.assertRegex(section, r"^\[\d+\.\d+\.\d+\] - \d{4}-\d{2}-\d{2}$")
        kinds = set(re.findall(r"^### (.*)$", self.text, re.M))
        self.assertLessEqual(kinds, {"Added", "Changed", "Deprecated", "Removed", "Fixed", "Security"})


if __name__ == "__main__":
    Version.program = sys.argv.pop(1)
    unittest.main()
