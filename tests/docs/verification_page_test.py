"""docs/verification: README's summary is that of docs/verification.md, and the comparison finds what it is there to find."""

import copy
import importlib.machinery
import importlib.util
import json
import pathlib
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
LOADER = importlib.machinery.SourceFileLoader("verification", str(ROOT / "docs" / "verification"))
verification = importlib.util.module_from_spec(importlib.util.spec_from_loader("verification", LOADER))
LOADER.exec_module(verification)

PAGE = """# Page

## two_bars: bars, against waves

<!-- rows: two_bars -->
| quantity | value | reference | error | tolerance | source |
|---|---|---|---|---|---|
| impulse [N s] | 0.962907 | 1 | 3.7e-02 | 0.05 | exact |
| drift | 3.46945e-15 | 0 | 3.5e-15 | 1e-12 | conservation |
<!-- end of rows -->

## rod_plate: rod

<!-- rows: rod_plate -->
| quantity | value | reference | error | tolerance | source |
|---|---|---|---|---|---|
| balance | 0.004 | 0 | 4.0e-03 | 0.01 | conservation |
<!-- end of rows -->
"""
README = """# Readme
<!-- verification: written by docs/verification -->
<!-- end of verification -->
"""


class Pages(unittest.TestCase):
    def test_belong_together(self):
        page, readme = verification.PAGE.read_text(), verification.README.read_text()
        self.assertEqual(verification.problems_of_pages(page, readme), [])
        self.assertGreaterEqual(sum(len(rows) for rows in verification.rows_of_page(page).values()), 200)

    def test_have_no_row_that_fails(self):
        for scene, rows in verification.rows_of_page(verification.PAGE.read_text()).items():
            for row in rows:
                with self.subTest(f"{scene}: {row.quantity}"):
                    self.assertLessEqual(row.error, row.tolerance)


class Results(unittest.TestCase):
    def setUp(self):
        self.page = verification.rows_of_page(PAGE)
        self.results = {"two_bars": [verification.Row("impulse [N s]", 0.96290712, 1, 0.03709288, 0.05, "exact"),
                                     verification.Row("drift", 3.469446e-15, 0, 3.469446e-15, 1e-12, "conservation")],
                        "rod_plate": [verification.Row("balance", 0.004, 0, 0.004, 0.01, "conservation")]}

    def found(self, scene, number, **changes):
        results = copy.deepcopy(self.results)
        for name, value in changes.items():
            setattr(results[scene][number], name, value)
        return list(verification.differences(self.page, results))

    def test_of_the_page_are_the_same(self):
        self.assertEqual(list(verification.differences(self.page, self.results)), [])

    def test_may_differ_by_a_small_part_of_the_tolerance(self):
        self.assertEqual(self.found("two_bars", 0, value=0.9649, error=0.0351), [])
        self.assertEqual(len(self.found("two_bars", 0, value=0.97, error=0.03)), 1)

    def test_may_differ_by_round_off(self):
        self.assertEqual(self.found("two_bars", 1, value=7e-13, error=7e-13), [])

    def test_of_another_kind_are_found(self):
        self.assertEqual(len(self.found("two_bars", 0, quantity="impulse")), 1)
        self.assertEqual(len(self.found("two_bars", 0, source="guessed")), 1)
        self.assertEqual(len(self.found("two_bars", 0, tolerance=0.051)), 1)
        self.assertEqual(len(self.found("two_bars", 0, reference=1.01)), 1)

    def test_that_round_off_decides_need_the_same_tolerance_alone(self):
        self.assertEqual(self.found("rod_plate", 0, value=0.009, error=0.009), [])
        self.assertEqual(len(self.found("rod_plate", 0, tolerance=0.02)), 1)

    def test_of_more_rows_or_scenes_are_found(self):
        self.results["two_bars"].pop()
        self.results["other"] = []
        self.assertEqual(len(list(verification.differences(self.page, self.results))), 2)

    def test_of_a_file_that_fail_are_named(self):
        row = {"scene": "two_bars", "quantity": "drift", "value": None, "reference": 0, "source": "", "error": None,
               "tolerance": 0, "pass": False}
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump({"rows": [row]}, file)
            file.flush()
            rows, failed = verification.read_results(file.name)
        self.assertEqual((rows, len(failed)), ({}, 1))


class Fix(unittest.TestCase):
    def test_writes_rows_and_summary(self):
        row = verification.Row("impulse [N s]", 0.98, 1, 0.02, 0.05, "exact")
        page = verification.with_rows(PAGE, {"two_bars": [row]})
        self.assertEqual(verification.rows_of_page(page)["two_bars"], [row])
        self.assertEqual(len(verification.rows_of_page(page)["rod_plate"]), 1)
        readme = verification.with_summary(README, page)
        self.assertIn("| `two_bars` | bars, against waves | 1 | 0.40 |\n", readme)
        self.assertEqual(verification.problems_of_pages(page, readme), [])
        self.assertEqual(len(verification.problems_of_pages(PAGE, readme)), 1)

    def test_needs_a_section_for_each_table(self):
        self.assertEqual(len(verification.problems_of_pages(PAGE.replace("## rod_plate: rod", ""), README)), 1)


if __name__ == "__main__":
    unittest.main()
