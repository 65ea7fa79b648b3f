"""What bench/threads makes of its measurements."""

import unittest

from bench_command import load_command

threads = load_command("threads")


class Threads(unittest.TestCase):
    def test_are_powers_of_two_and_all(self):
        self.assertEqual([threads.numbers_of_threads(n) for n in (1, 2, 6, 8)], [[1], [1, 2], [1, 2, 4, 6], [1, 2, 4, 8]])

    def test_a_default_that_is_not_the_best_loses(self):
        rows = threads.rows_of([("large", 10_000, 2, {1: 0.02, 2: 0.011}), ("small", 100, 2, {1: 0.001, 2: 0.0015})])
        self.assertEqual([cells[0] for cells, _ in rows], ["small", "large"])
        self.assertAlmostEqual(rows[0][1], 0.5)
        self.assertEqual(rows[1][1], 0)
        self.assertEqual(rows[0][0], ["small", "100", "1e+03", "1.5e+03", "2", "50 %"])

    def test_a_failing_program_is_an_error(self):
        with self.assertRaises(Exception):
            threads.run("/bin/false", "two_blocks", 1, 0, 1, "/nowhere")


if __name__ == "__main__":
    unittest.main()
