"""What bench/forecast reads of pinball info, and what it counts."""

import unittest

from bench_command import load_command

forecast = load_command("forecast")


class Foretold(unittest.TestCase):
    def test_times_of_every_length(self):
        line = "  607 steps to 5.4e-05 s, {}run time {} (0.18 ms per step, 10.1 million element steps per second)"
        for time, expected in (("about 0.16 s", (607, False, 0.16)), ("under 0.1 s", (607, True, 0.1)),
                               ("about 3 min 05 s", (607, False, 185.0)), ("about 2 h 10 min", (607, False, 7800.0))):
            self.assertEqual(forecast.foretold(line.format("", time)), expected)
        self.assertEqual(forecast.foretold(line.format("all made just now, ", "under 0.1 s")), (607, True, 0.1))
        self.assertIsNone(forecast.foretold("  the run fails: negative volume"))

    def test_what_is_within(self):
        self.assertTrue(forecast.is_within(False, 1.0, 1.4) and forecast.is_within(False, 1.4, 1.0))
        self.assertFalse(forecast.is_within(False, 1.0, 1.6) or forecast.is_within(False, 1.6, 1.0))
        self.assertTrue(forecast.is_within(True, 0.1, 0.001))
        self.assertFalse(forecast.is_within(True, 0.1, 0.2))


if __name__ == "__main__":
    unittest.main()
