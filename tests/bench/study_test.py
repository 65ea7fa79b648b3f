"""bench/study --quick from its call to its page: study_test.py FOLDER. No time is judged.

Every section is there; every number of the page is the one of results.json at the place that it names; frontier, orders
and costs follow from the points; and errors are those of `pinball verify`.
"""

import json
import math
import os
import re
import subprocess
import sys
import unittest

import bench_command
import bench_page
from bench_page import half_of_last_digit, lookup

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
STUDY = os.path.join(ROOT, "bench", "study")
PINBALL = os.path.join(ROOT, "build", "release", "pinball")
OUT = ""


class Calls(bench_command.Calls, unittest.TestCase):
    command = STUDY

    def test_bad_input(self):
        for arguments, said in ((["--scene", "nowhere"], "two_bars"), (["--rounds", "0"], "--rounds"),
                                (["--out", os.path.join(STUDY, "below")], "--out")):  # a file is in the way
            done = self.call(*arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(said, done.stderr)

    def test_markdown_of_nothing(self):
        done = self.call("--markdown", "--out", os.path.join(OUT, "nothing"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("results.json", done.stderr)


class QuickForm(bench_page.QuickForm, unittest.TestCase):
    command = STUDY

    @classmethod
    def setUpClass(cls):
        cls.out = OUT
        super().setUpClass()
        cls.studies = {s["name"]: s for s in cls.results["studies"]}

    def curves(self):
        for study in self.results["studies"]:
            for curve in study["curves"]:
                yield study, curve, [p for p in curve["points"] if p["failure"] is None]

    def test_every_section_is_there(self):
        self.assertEqual(list(self.page.sections),
                         ["conclusion", *self.studies, "rod_oblique", "candidates", "precision", "machine", "repeat"])
        for name, text in self.page.sections.items():
            self.assertGreater(len(text), 100, name)

    def test_is_self_contained(self):
        drawn = [s for s in self.results["studies"] if s["curves"]]
        self.assertGreater(len(self.page.images), len(drawn))
        for image in self.page.images:
            self.assertTrue(image["src"].startswith("data:image/png;base64,iVBOR"), image["alt"])
        self.assertIsNone(re.search(r"<(script|link|iframe)|https?://|url\(", self.text))

    def test_numbers_are_those_of_the_results(self):
        self.assertGreater(len(self.page.numbers), 500)
        for number in self.page.numbers:
            value = lookup(self.results, number["data-pointer"])
            self.assertEqual(json.loads(number["value"]), value, number)
            shown, scaled = float(number["text"].replace(",", "")), value * float(number["data-scale"])
            self.assertLessEqual(abs(shown - scaled), half_of_last_digit(number["text"]), number)

    def test_begins_with_what_follows_from_the_numbers(self):
        self.assertEqual(next(iter(self.page.sections)), "conclusion")
        concluded = [n for n in self.page.numbers if n["section"] == "conclusion"]
        self.assertGreater(len(concluded), 10)

    def test_points_are_whole(self):
        for study, curve, good in self.curves():
            self.assertTrue(good, (study["name"], curve["method"]))
            for point in good:
                self.assertEqual(set(point["errors"]), {q["key"] for q in study["quantities"]})
                self.assertEqual(point["seconds"], min(point["times"]))
                self.assertTrue(all(math.isfinite(e) and e >= 0 for e in point["errors"].values()), point)

    def test_frontier_follows_from_the_points(self):
        for study in self.results["studies"]:
            for key, frontier in study["frontier"].items():
                everything = [(p["seconds"], p["errors"][key]) for s, _, good in self.curves() if s is study for p in good]
                best = [study["curves"][c]["points"][p] for c, p in frontier]
                best = [(p["seconds"], p["errors"][key]) for p in best]
                for one in everything:
                    beaten = any(b[0] <= one[0] and b[1] <= one[1] for b in best)
                    self.assertTrue(beaten, (study["name"], key, one))
                for b in best:
                    self.assertFalse(any(o[0] <= b[0] and o[1] < b[1] for o in everything), (study["name"], key, b))

    def test_orders_follow_from_the_points(self):
        found = 0
        for study, curve, good in self.curves():
            for key, order in curve["orders"].items():
                x, y = [math.log(1 / p["mesh"]) for p in good], [p["errors"][key] for p in good]
                if len(good) < 3 or min(y) <= 0:
                    continue
                y = [math.log(e) for e in y]
                mx, my = sum(x) / len(x), sum(y) / len(y)
                slope = sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)
                self.assertAlmostEqual(order["order"], slope, msg=f"{study['name']}, {curve['method']}, {key}")
                found += 1
        self.assertGreater(found, 20)

    def test_costs_lie_between_the_points(self):
        for study, curve, good in self.curves():
            for key, costs in curve["costs"].items():
                errors = [p["errors"][key] for p in good]
                for aim, cost in zip(study["aims"], costs):
                    if errors[-1] > aim:
                        self.assertIsNone(cost)
                        continue
                    above = max((i for i, e in enumerate(errors) if e > aim), default=None)
                    self.assertEqual(cost["at_most"], above is None)
                    if above is None:
                        self.assertEqual(cost["seconds"], good[0]["seconds"])
                    else:
                        a, b = good[above], good[above + 1]
                        part = math.log(aim / a["errors"][key]) / math.log(b["errors"][key] / a["errors"][key])
                        self.assertAlmostEqual(cost["seconds"], a["seconds"] * (b["seconds"] / a["seconds"]) ** part)

    def test_cheapest_is_one_of_the_costs(self):
        for study in self.results["studies"]:
            for key, cheapest in study["cheapest"].items():
                for i, best in enumerate(cheapest):
                    costs = {c["method"]: c["costs"][key][i] for c in study["curves"] if c["costs"][key][i]}
                    self.assertEqual(best is None, not costs)
                    if best:
                        self.assertEqual(best["seconds"], costs[best["method"]]["seconds"])
                        self.assertLessEqual(best["seconds"], 1.1 * min(c["seconds"] for c in costs.values()))

    def test_candidates_follow_from_the_points(self):
        for entry in self.results["candidates"]:
            study = self.studies[entry["study"]]
            at = {c["method"]: p for c in study["curves"] for p in c["points"] if p["mesh"] == entry["mesh"]}
            for row in entry["rows"]:
                own, plain = at[row["method"]], at["plain"]
                key = entry["quantity"]
                self.assertEqual(row["error"], {"plain": plain["errors"][key], "own": own["errors"][key]})
                self.assertAlmostEqual(row["time"], own["seconds"] / plain["seconds"])

    def test_errors_are_those_of_verify(self):
        out = os.path.join(OUT, "verify.json")
        subprocess.run([PINBALL, "verify", "two_bars", "plate_impact", "--json", out], check=True, stdout=subprocess.DEVNULL)
        with open(out, encoding="utf-8") as file:
            verified = json.load(file)
        rows = verified if isinstance(verified, list) else verified["rows"]
        value = {(row["scene"], row["quantity"]): row["value"] for row in rows}

        def error(study, method, mesh, key):
            curve = next(c for c in self.studies[study]["curves"] if c["method"] == method)
            return next(p for p in curve["points"] if p["mesh"] == mesh)["errors"][key]

        for method, name in (("plain", "penalty"), ("faces, projection", "projection"), ("faces, lagrange", "lagrange"),
                             ("slideline, penalty", "slideline, penalty"), ("slideline, lagrange", "slideline, lagrange")):
            for mesh in (10, 40):
                for key in ("faces", "middles"):
                    quantity = f"{name}: mean error of the velocity at the {key} / v0, {mesh} elements"
                    expected = value["two_bars", quantity]
                    self.assertAlmostEqual(error("two_bars", method, mesh, key), expected, delta=1e-3 * expected, msg=quantity)
        for method, name in (("plain", "bulk viscosity"), ("no bulk viscosity", "no viscosity")):
            for mesh in (25, 50, 100):
                quantity = f"mean error of velocities / impact velocity, {mesh} elements, {name}"
                expected = value["plate_impact", quantity]
                self.assertAlmostEqual(error("plate_impact", method, mesh, "velocity"), expected, delta=1e-3 * expected,
                                       msg=quantity)

    def test_tables_have_the_same_numbers(self):
        rows = bench_command.rows_of(OUT, "points.csv")
        self.assertEqual(len(rows), sum(len(curve["points"]) * len(study["quantities"]) for study, curve, _ in self.curves()))
        for row in rows:
            if row["failure"]:
                continue
            curve = next(c for c in self.studies[row["study"]]["curves"] if c["method"] == row["method"])
            point = next(p for p in curve["points"] if str(p["mesh"]) == row["mesh"])
            self.assertEqual(float(row["error"]), point["errors"][row["quantity"]])
            self.assertEqual(float(row["seconds"]), point["seconds"])
        for row in bench_command.rows_of(OUT, "candidates.csv"):
            compared = row["study"], row["quantity"]
            entry = next(e for e in self.results["candidates"] if (e["study"], e["quantity"]) == compared)
            found = next(r for r in entry["rows"] if r["method"] == row["method"])
            self.assertEqual(float(row["time_over_plain"]), found["time"])
        for name in ("parameters", "orders", "cheapest", "ensemble"):
            self.assertTrue(bench_command.rows_of(OUT, name + ".csv"), name)

    def test_markdown_is_made_of_the_results(self):
        done = subprocess.run([STUDY, "--markdown", "--out", OUT], capture_output=True, text=True, check=True)
        for study in self.results["studies"]:
            if any(p["mesh"] == study["report_mesh"] and p["failure"] is None for c in study["curves"] for p in c["points"]):
                self.assertIn(study["title"], done.stdout)

    def test_names_nothing_of_the_place_where_it_was_made(self):
        with open(os.path.join(OUT, "results.json"), encoding="utf-8") as file:
            written = file.read()
        for text in (self.text, written):
            self.assertNotIn(os.path.realpath(ROOT), text)
            self.assertNotIn("/tmp/", text)


if __name__ == "__main__":
    OUT = sys.argv.pop()
    unittest.main()
