"""What bench/ballistic_limit makes: the mesh of the plate, the curve that fits shots, and the limit between them."""

import os
import re
import sys
import tempfile
import unittest
from unittest import mock

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))

from bench_command import load_command

limit = load_command("ballistic_limit")
MESH = os.path.join(limit.ROOT, "data", "scenes", "perforated_plate.msh")


def recht_ipson(a, p, bound, speed):
    return a * (speed**p - bound**p) ** (1 / p)


class Mesh(unittest.TestCase):
    def test_that_of_the_scene_is_the_one_that_is_written(self):
        with tempfile.TemporaryDirectory() as where:
            path = os.path.join(where, "plate.msh")
            limit.write_mesh(path, 0.5)
            with open(path, encoding="ascii") as written, open(MESH, encoding="ascii") as kept:
                self.assertEqual(written.read(), kept.read())

    def test_elements_have_one_size_about_the_edge_and_end_at_the_rim(self):
        for size in (1.0, 0.5, 0.25):
            places = limit.radii(size)
            self.assertAlmostEqual(places[-1], limit.RADIUS)
            self.assertTrue(any(abs(r - limit.EDGE) < 1e-9 for r in places))
            widths = [(b - a, (a + b) / 2) for a, b in zip(places, places[1:])]
            for width, middle in widths:
                if abs(middle - limit.EDGE) < limit.FINE:
                    self.assertAlmostEqual(width, size)
            for (one, _), (next_one, _) in zip(widths, widths[1:]):
                self.assertLess(max(one / next_one, next_one / one), 1.35)


class Curve(unittest.TestCase):
    def test_recht_and_ipson_are_found_again(self):
        points = [(v, recht_ipson(0.79, 2.36, 184.5, v)) for v in (303.5, 285.4, 244.2, 224.7, 200.4, 189.6)]
        a, p, bound = limit.fit(points, 181.5)
        self.assertAlmostEqual(a, 0.79, delta=0.01)
        self.assertAlmostEqual(p, 2.36, delta=0.05)
        self.assertAlmostEqual(bound, 184.5, delta=0.3)


class Shots(unittest.TestCase):
    def series(self, bracket):
        """Of a plate that stops what is slower than 200."""
        def shoot(speed, settings, folder):
            through = speed > 200
            residual = recht_ipson(0.8, 2, 200, speed) if through else -2.0
            return {"speed": speed, "through": through, "residual": residual, "way": 1, "eroded": 0, "balance": 0.0,
                    "seconds": 0.0}

        with mock.patch.object(limit, "shoot", shoot), mock.patch("builtins.print"):
            return limit.series("", [], [300.0, 250.0, 180.0], bracket, "")

    def test_the_limit_is_between_two_shots_that_are_near(self):
        for bracket in (8.0, 1.0):
            found = self.series(bracket)
            self.assertAlmostEqual(found["limit"], 200, delta=bracket / 2)

    def test_a_shot_that_is_stopped_has_no_velocity_left(self):
        stopped = {"speed": 184.3, "through": False, "residual": 3.0, "way": 9, "eroded": 1, "balance": 0.0, "seconds": 1.0}
        self.assertTrue(re.match(r" +184\.3 +0\.0 +30\.8 +9\.0 ", limit.line_of(stopped)))
        self.assertIn("no disk", limit.line_of({"speed": 1.0, "failed": ["no disk"]}))


if __name__ == "__main__":
    unittest.main()
