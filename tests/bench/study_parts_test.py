"""What bench/study makes of points, on made-up ones: study_parts_test.py."""

import os
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))

from report_parts.builds import ROOT, Failed
from report_parts.pointers import Numbers
from study_parts import analysis, candidates, conclusion, markdown, precision, runs, scenes, spheres, sweep, two_bars, variants
from study_parts.study import Setup, Variant


def point(mesh, seconds, error, failure=None):
    return {"mesh": mesh, "seconds": seconds, "times": [seconds], "steps": 10, "elements": mesh, "failure": failure,
            "errors": {} if failure else {"error": error}}


def part_of(**curves):
    """The part of the results of a made-up study, with what follows from the points."""
    part = {"name": "two_bars", "title": "Made up", "mesh": "elements", "report_mesh": 10, "absent": [], "sweeps": [],
            "quantities": [{"key": "error", "title": "error", "norm": "as given"}],
            "curves": [{"method": name, "points": [point(*p) for p in points]} for name, points in curves.items()]}
    sweep.derive(part)
    return part


class Frontier(unittest.TestCase):
    def test_keeps_what_nothing_else_beats(self):
        points = [(1.0, 0.1), (2.0, 0.05), (2.5, 0.06), (4.0, 0.01), (0.5, 0.3), (8.0, 0.01)]
        self.assertEqual(analysis.frontier(points), [4, 0, 1, 3])

    def test_of_equal_times_the_more_accurate(self):
        self.assertEqual(analysis.frontier([(1.0, 0.2), (1.0, 0.1)]), [1])

    def test_need_not_be_convex(self):
        self.assertEqual(analysis.frontier([(1.0, 1.0), (2.0, 0.99), (3.0, 0.1)]), [0, 1, 2])

    def test_failed_runs_are_no_points(self):
        self.assertEqual(analysis.frontier([(1.0, None), (2.0, 0.1)]), [1])


class Orders(unittest.TestCase):
    def test_slope_of_a_power_law(self):
        found = analysis.order([1.0, 0.5, 0.25], [3.0, 0.75, 0.1875])
        self.assertAlmostEqual(found["order"], 2.0)
        self.assertAlmostEqual(found["residual"], 0.0)

    def test_residual_is_in_decades(self):
        found = analysis.order([1.0, 0.1, 0.01], [1.0, 10.0, 1.0])
        self.assertAlmostEqual(found["order"], 0.0)
        self.assertAlmostEqual(found["residual"], np.sqrt(2) / 3)

    def test_two_points_have_no_order(self):
        self.assertIsNone(analysis.order([1.0, 0.5, 0.25], [1.0, 0.5, None]))
        self.assertIsNone(analysis.order([1.0, 0.5, 0.25], [1.0, 0.5, 0.0]))


class Costs(unittest.TestCase):
    def test_between_points_on_logarithmic_scales(self):
        found = analysis.cost([(1.0, 0.1), (100.0, 0.001)], 0.01)
        self.assertAlmostEqual(found["seconds"], 10.0)
        self.assertFalse(found["at_most"])

    def test_is_never_continued_beyond_the_points(self):
        self.assertIsNone(analysis.cost([(1.0, 0.1), (10.0, 0.02)], 0.01))
        self.assertEqual(analysis.cost([(1.0, 0.001), (10.0, 0.0001)], 0.01), {"seconds": 1.0, "at_most": True})

    def test_an_error_that_comes_back_is_not_reached(self):
        self.assertIsNone(analysis.cost([(1.0, 0.1), (2.0, 0.001), (4.0, 0.02)], 0.01))
        reached = analysis.cost([(1.0, 0.1), (2.0, 0.001), (4.0, 0.02), (8.0, 0.005)], 0.01)
        self.assertAlmostEqual(reached["seconds"], 4 * np.sqrt(2))

    def test_nothing_measured_costs_nothing(self):
        self.assertIsNone(analysis.cost([(1.0, None)], 0.01))

    def test_cheapest_is_the_first_to_get_there(self):
        curves = {"plain": [(1.0, 0.1), (10.0, 0.02)], "slow": [(5.0, 0.001)], "fast": [(1.0, 0.1), (3.0, 0.005)]}
        self.assertEqual(analysis.cheapest(curves, 0.01)["method"], "fast")
        self.assertIsNone(analysis.cheapest(curves, 1e-4))

    def test_noise_is_no_merit(self):
        curves = {"plain": [(1.0, 0.01)], "the same": [(0.95, 0.01)]}
        self.assertEqual(analysis.cheapest(curves, 0.01)["method"], "plain")


class Derived(unittest.TestCase):
    def setUp(self):
        self.part = part_of(plain=[(10, 1.0, 0.1), (20, 10.0, 0.05), (40, 100.0, 0.025)],
                            better=[(10, 1.1, 0.04), (20, 11.0, 0.02), (40, 110.0, 0.01)],
                            float=[(10, 0.6, 0.1), (20, 5.0, 0.06), (40, 50.0, 0.0, "blew up")])

    def test_orders_costs_and_frontier_are_per_curve(self):
        plain, better, single = self.part["curves"]
        self.assertAlmostEqual(plain["orders"]["error"]["order"], 1.0)
        self.assertIsNone(single["orders"]["error"])
        self.assertAlmostEqual(better["costs"]["error"][1]["seconds"], 110.0)
        self.assertEqual(self.part["frontier"]["error"], [[2, 0], [1, 0], [1, 1], [1, 2]])
        self.assertEqual(self.part["cheapest"]["error"][0]["method"], "better")
        self.assertIsNone(self.part["cheapest"]["error"][2])

    def test_candidates_are_judged_at_the_resolution_of_the_report(self):
        candidate = candidates.compare(self.part, "error", self.part["curves"][0], self.part["curves"][1])
        self.assertAlmostEqual(candidate["gain"], 2.5)
        self.assertAlmostEqual(candidate["time"], 1.1)
        self.assertTrue(candidate["met"])
        same = candidates.compare(self.part, "error", self.part["curves"][0], self.part["curves"][2])
        self.assertAlmostEqual(same["gain"], 1.0)
        self.assertFalse(same["met"])

    def test_float_beside_double(self):
        row, = precision.derive([self.part])
        self.assertEqual((row["mesh"], row["double"], row["float"], row["failures"]), (20, 0.05, 0.06, 1))
        self.assertAlmostEqual(row["time"], 0.5)

    def test_conclusions_name_best_and_failed(self):
        results = {"studies": [self.part], "candidates": [], "precision": []}
        said = " ".join(conclusion.lines(Numbers(results)))
        self.assertIn("least with better", said)
        self.assertIn("two_bars, float, 40", said)

    def test_markdown_has_the_same_numbers(self):
        text = markdown.render({"studies": [self.part], "precision": precision.derive([self.part]), "ensemble": None, "form": "full",
                                "rounds": 3, "seconds": 9.6, "machine": {"cpu": "a processor", "revision": "abc"}})
        self.assertIn("full form, 3 rounds, 10 s; a processor; revision abc\n", text)
        self.assertIn("| better | 4 % | 1.1 |", text)
        self.assertIn("better, at most 1.1 s", text)
        self.assertIn("## Single precision\n", text)
        self.assertNotIn("oblique", text)  # nothing of what was not measured


class Variants(unittest.TestCase):
    def test_titles_are_unique_and_the_plain_one_is_first(self):
        titles = [v.title for v in variants.VARIANTS]
        self.assertEqual(len(set(titles)), len(titles))
        self.assertEqual(titles[0], variants.PLAIN_TITLE)

    def test_studies_name_variants_that_exist(self):
        titles = {v.title for v in variants.VARIANTS}
        for study in scenes.STUDIES:
            named = {*study.without, *study.foremost, *(t for s in study.sweeps for t in s.variants)}
            self.assertLessEqual(named, titles, study.name)
            self.assertLessEqual(set(study.groups), {v.group for v in variants.VARIANTS}, study.name)

    def test_finest_meshes_are_for_the_foremost(self):
        study = spheres.FLOOR
        self.assertEqual(sweep.meshes_of(study, "full", Variant("contact", "another")), [8, 12, 16])
        self.assertEqual(sweep.meshes_of(study, "full", Variant("plain", variants.PLAIN_TITLE)), study.meshes["full"])


class Commands(unittest.TestCase):
    def test_a_changed_scene_is_written(self):
        with tempfile.TemporaryDirectory() as where:
            setup = Setup("two_bars", ["time.end=1"], more="[damping]\nmass = 1.0\n", replace=(("end = 8.0", "end = 9.0"),))
            line = runs.command("run", setup, Variant("step", "float", ("time.cfl=0.5",), precision="float"), where)
            with open(os.path.join(where, "two_bars.toml"), encoding="utf-8") as file:
                text = file.read()
        self.assertIn("end = 9.0", text)
        self.assertTrue(text.endswith("mass = 1.0\n"))
        self.assertEqual(line[line.index("--precision") + 1], "float")
        self.assertLess(line.index("contact.enforcement=penalty"), line.index("time.cfl=0.5"))  # the last one counts

    def test_a_change_must_find_its_place(self):
        with tempfile.TemporaryDirectory() as where, self.assertRaises(Failed):
            runs.command("run", Setup("two_bars", [], replace=(("nowhere in it", ""),)), variants.VARIANTS[0], where)

    def test_every_study_has_its_scene(self):
        for study in scenes.STUDIES:
            setup = study.setup(study.meshes["quick"][0], variants.VARIANTS[0])
            self.assertTrue(os.path.exists(os.path.join(ROOT, "data", "scenes", setup.scene + ".toml")), study.name)


class References(unittest.TestCase):
    def test_exact_velocities_of_the_bars(self):
        self.assertEqual(two_bars.exact(1, np.array([-0.1, 1.0, 2.1])).tolist(), [1.0, 0.5, 0.0])
        self.assertEqual(two_bars.exact(3, np.array([0.4, 1.0, 1.6])).tolist(), [0.0, 0.5, 1.0])

    def test_smooth_curve_goes_through_its_points_and_keeps_parabolas(self):
        x = np.linspace(0.0, 1.0, 6)
        self.assertTrue(np.allclose(spheres.smooth(x, x**3, x), x**3))
        inner = np.array([0.3, 0.5, 0.7])
        self.assertTrue(np.allclose(spheres.smooth(x, x**2, inner), inner**2))


if __name__ == "__main__":
    unittest.main()
