"""bench/report --quick from its call to its page: report_test.py FOLDER.

Every section is there; every number of the page is the one of results.json at the place that it names; the tables beside
it have the same numbers; and what is derived from other numbers follows from them.
"""

import json
import math
import os
import re
import statistics
import subprocess
import sys
import unittest

import bench_command
import bench_page
from bench_page import half_of_last_digit, lookup

BENCH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench")
REPORT = os.path.join(BENCH, "report")
SECTIONS = ["conclusion", "machine", "aims", "comparison", "stages", "kernels", "work", "differences", "repeat"]
FIGURES = 5  # stages, speed-ups, roofline, totals, sliding
OUT = ""


class Calls(bench_command.Calls, unittest.TestCase):
    command = REPORT

    def test_bad_input(self):
        self.assertEqual(self.call("--fast").returncode, 2)
        done = self.call("--out", os.path.join(REPORT, "below"))  # a file is in the way
        self.assertEqual(done.returncode, 2)
        self.assertIn("--out", done.stderr)

    def test_missing_tool(self):
        done = subprocess.run([sys.executable, REPORT, "--quick", "--out", OUT], capture_output=True, text=True,
                              env={**os.environ, "PATH": os.path.dirname(REPORT)})
        self.assertEqual(done.returncode, 1)
        self.assertIn("cmake is needed", done.stderr)


class QuickForm(bench_page.QuickForm, unittest.TestCase):
    command = REPORT

    @classmethod
    def setUpClass(cls):
        cls.out = OUT
        super().setUpClass()

    def test_every_section_is_there(self):
        self.assertEqual(list(self.page.sections), SECTIONS)
        for name, text in self.page.sections.items():
            self.assertGreater(len(text), 100, name)

    def test_is_self_contained(self):
        self.assertEqual(len(self.page.images), FIGURES)
        for image in self.page.images:
            self.assertTrue(image["src"].startswith("data:image/png;base64,iVBOR"), image["alt"])
        self.assertIsNone(re.search(r"<(script|link|iframe)|https?://|url\(", self.text))

    def test_numbers_are_those_of_the_results(self):
        self.assertGreater(len(self.page.numbers), 300)
        for number in self.page.numbers:
            value = lookup(self.results, number["data-pointer"])
            self.assertEqual(json.loads(number["value"]), value, number)
            shown, scaled = float(number["text"].replace(",", "")), value * float(number["data-scale"])
            self.assertLessEqual(abs(shown - scaled), half_of_last_digit(number["text"]), number)

    def assert_stages_are_the_whole(self, method, medians, contact, total):
        """In every repeat; medians of the stages need not add up to the median of the whole on a busy machine."""
        repeats = method["repeats"]
        for stage, seconds in medians.items():
            self.assertAlmostEqual(seconds, statistics.median(r[stage] for r in repeats))
        of_contact = [sum(s for stage, s in r.items() if stage.startswith("contact")) for r in repeats]
        self.assertAlmostEqual(statistics.median(of_contact), contact["median"])
        self.assertAlmostEqual(statistics.median(sum(r.values()) for r in repeats), total["median"])

    def test_ratios_follow_from_the_times(self):
        columns = self.results["comparison"]["columns"]
        self.assertEqual([c["title"] for c in columns[:3]], ["example 1", "example 2, mesh 1", "example 2, mesh 2"])
        for column in columns:
            slideline, pinball = (column["methods"][m] for m in ("slideline", "pinball"))
            for what in ("total", "contact"):
                self.assertAlmostEqual(column["ratio"][what],
                                       slideline["seconds"][what]["median"] / pinball["seconds"][what]["median"])
            for method in (slideline, pinball):
                self.assertIsNone(method["failure"])
                self.assertAlmostEqual(sum(s["share"] for s in method["stages"].values()), 1)
                self.assert_stages_are_the_whole(method, {s: x["seconds"] for s, x in method["stages"].items()},
                                                 method["seconds"]["contact"], method["seconds"]["total"])
                self.assertAlmostEqual(method["share"], method["seconds"]["contact"]["median"]
                                       / method["seconds"]["total"]["median"])
            share = pinball["share"]
            self.assertEqual(column["aims"]["share"], {"value": share, "met": share <= 0.15})
        aims = self.results["comparison"]["aims"]
        self.assertEqual(aims["contact"]["met"], min(c["ratio"]["contact"] for c in columns[:3]) >= 5)
        self.assertEqual(aims["total"]["met"], min(c["ratio"]["total"] for c in columns[:3]) >= 1.5)

    def test_speed_ups_follow_from_the_times(self):
        section = self.results["vectorization"]
        self.assertGreaterEqual(section["listed"], 100_000)
        for kernel in section["kernels"]:
            base = kernel["builds"]["no-vectorization"]
            self.assertIsNone(base["lanes_used"], kernel["key"])
            for build in kernel["builds"].values():
                self.assertAlmostEqual(build["speed_up"], base["seconds"]["median"] / build["seconds"]["median"])
                self.assertGreater(build["bytes_per_item"], 0)
            self.assertIn(kernel["vectorized"]["verdict"], ("yes", "partly", "no"))
            agree = len({kernel["vectorized"][s] for s in ("compiler", "machine_code", "speed")}) == 1
            self.assertTrue(agree or kernel["vectorized"]["explanations"], kernel["key"])

    def test_one_lane_build_has_one_lane(self):
        for kernel in self.results["vectorization"]["kernels"]:
            code = kernel["builds"]["no-vectorization"]["code"]
            self.assertEqual((code["packed_zmm"], code["packed_ymm"]), (0, 0), kernel["key"])
        self.assertEqual(self.results["stages"][0]["builds"]["no-vectorization"]["simd_width"], 1)
        self.assertEqual(list(self.results["stages"][0]["builds"]), ["no-vectorization", "release"], "avx2 takes minutes to build")

    def test_stages_are_the_whole(self):
        for series in self.results["stages"]:
            for build in series["builds"].values():
                for method in ("slideline", "pinball"):
                    one = build[method]
                    self.assert_stages_are_the_whole(one, {s: x["median"] for s, x in one["stages"].items()},
                                                     one["contact"], one["total"])

    def test_tables_have_the_same_numbers(self):
        for row in bench_command.rows_of(OUT, "comparison.csv"):
            column = next(c for c in self.results["comparison"]["columns"] if c["title"] == row["column"])
            self.assertEqual(float(row["seconds_total"]), column["methods"][row["method"]]["seconds"]["total"]["median"])
            self.assertEqual(float(row["ratio_contact"]), column["ratio"]["contact"])
        kernels = {k["key"]: k for k in self.results["vectorization"]["kernels"]}
        rows = bench_command.rows_of(OUT, "kernels.csv")
        self.assertEqual(len(rows), sum(len(kernel["builds"]) for kernel in kernels.values()))
        for row in rows:
            self.assertEqual(float(row["speed_up"]), kernels[row["kernel"]]["builds"][row["build"]]["speed_up"])
        for row in bench_command.rows_of(OUT, "stages.csv"):
            series = next(s for s in self.results["stages"] if str(s["refine"]) == row["refine"])
            if row["stage"] == "total":
                self.assertEqual(float(row["seconds_median"]),
                                 series["builds"][row["build"]][row["method"]]["total"]["median"])
        heights = [float(row["height"]) for row in bench_command.rows_of(OUT, "sliding.csv") if row["method"] == "pinball"]
        self.assertEqual(heights, self.results["sliding"]["methods"]["pinball"]["height"])
        self.assertTrue(all(math.isfinite(h) for h in heights))

    def test_names_nothing_of_the_place_where_it_was_made(self):
        self.assertNotIn(os.path.realpath(os.path.join(BENCH, "..")), self.text)


if __name__ == "__main__":
    OUT = sys.argv.pop()
    unittest.main()
