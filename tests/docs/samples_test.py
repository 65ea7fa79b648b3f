"""docs/samples: the pages' code is the files', and the check finds what it is there to find."""

import importlib.machinery
import importlib.util
import pathlib
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LOADER = importlib.machinery.SourceFileLoader("samples", str(ROOT / "docs" / "samples"))
samples = importlib.util.module_from_spec(importlib.util.spec_from_loader("samples", LOADER))
LOADER.exec_module(samples)


class Pages(unittest.TestCase):
    def test_show_the_code_of_the_files(self):
        self.assertGreaterEqual(sum("<!-- sample: " in page.read_text() for page in samples.PAGES), 2)
        for page in samples.PAGES:
            with self.subTest(page.name):
                text = page.read_text()
                self.assertEqual(samples.check(text), (text, []))


class Check(unittest.TestCase):
    file = "tests/data/sample.c"

    def page(self, name="loop", text="for (;;) {\n  step();\n}\n"):
        return f"Text.\n<!-- sample: {self.file} {name} -->\n```c\n{text}```\n"

    def test_takes_the_marked_part_without_its_indentation(self):
        self.assertEqual(samples.check(self.page()), (self.page(), []))

    def test_finds_and_mends_a_difference(self):
        text, problems = samples.check(self.page(text="for (;;) step();\n"))
        self.assertEqual(len(problems), 1)
        self.assertEqual(text, self.page())

    def test_finds_a_missing_mark_and_a_missing_file(self):
        self.assertEqual(len(samples.check(self.page(name="missing"))[1]), 1)
        self.assertEqual(len(samples.check(self.page().replace("sample.c", "missing.c"))[1]), 1)

    def test_finds_code_of_no_file(self):
        self.assertEqual(len(samples.check("```c\nstep();\n```\n")[1]), 1)
        self.assertEqual(samples.check("```text\nstep\n```\n")[1], [])

    def test_leaves_a_block_that_a_test_runs(self):
        page = "<!-- run by {} -->\n```sh\ntrue\n```\n"
        self.assertEqual(samples.check(page.format("tests/docs/samples_test.py"))[1], [])
        self.assertEqual(len(samples.check(page.format("tests/docs/missing.py"))[1]), 1)


if __name__ == "__main__":
    unittest.main()
