"""bench/speed from its call to its tables, with sizes that take seconds: speed_test.py FOLDER. No time is judged."""

import contextlib
import io
import math
import os
import sys
import unittest

import bench_command

SPEED = os.path.join(bench_command.BENCH, "speed")
OUT = ""


def load():
    sys.path.insert(0, bench_command.BENCH)
    return bench_command.load_command("speed")


class Calls(bench_command.Calls, unittest.TestCase):
    command = SPEED

    def test_bad_input(self):
        for arguments, said in ((["--rounds", "1"], "--rounds"), (["--lulesh", OUT], "--lulesh"),
                                (["--out", os.path.join(SPEED, "below")], "--out")):  # a file is in the way
            done = self.call(*arguments)
            self.assertEqual(done.returncode, 2)
            self.assertIn(said, done.stderr)

    def test_markdown_of_nothing(self):
        done = self.call("--markdown", "--out", os.path.join(OUT, "nothing"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("machine.json", done.stderr)


class SmallForm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        speed = load()
        case = speed.scenes.Case
        speed.FORMS["quick"] = {
            "rounds": 2,
            "sizes": [14, speed.whole_steps.SMALLEST],
            "cases": [case("rod_plate", "rod_plate", steps=20), case("taylor_bar", "taylor_bar", steps=5)],
            "clouds": [(speed.contact.SMALL, True)],
            "shuffled": (6, 10),
            "benchmark": ["--benchmark_min_time=0.001"],
        }
        with contextlib.redirect_stdout(io.StringIO()) as said:
            status = speed.main(["--quick", "--out", OUT])
        assert status == 0, f"bench/speed ended with status {status}"
        cls.said = said.getvalue()
        cls.measurements, cls.ratios, cls.table = (bench_command.rows_of(OUT, f"{name}.csv")
                                                   for name in ("measurements", "ratios", "table"))

    def test_says_where_to_look(self):
        self.assertIn(OUT, self.said)

    def test_everything_is_measured_in_both_rounds(self):
        rounds = [{tuple(row[k] for k in ("what", "size", "precision", "threads")) for row in self.measurements if row["round"] == n}
                  for n in ("0", "1")]
        self.assertEqual(*rounds)
        wanted = [("whole step", "2744", "float", "1"), ("whole step", "27000", "double", "2"),
                  ("memory bandwidth (triad)", "27000", "double", "1"), ("arithmetic peak", "27000", "double", "2"),
                  ("rod_plate: share of contact", "1842", "double", "1"), ("taylor_bar: speed", "3840", "double", "2"),
                  ("list from nothing, close-packed", "27000", "double", "1"),
                  ("contact forces, close-packed", "27000", "double", "2"),
                  ("contact forces, a tenth in contact, close-packed", "27000", "double", "1"),
                  ("rod_plate: contact in a step", "1842", "double", "1"), ("block, shuffled mesh: speed", "216", "double", "1")]
        self.assertLessEqual(set(wanted), rounds[0])

    def test_values_are_numbers_above_zero(self):
        for row in [*self.measurements, *self.ratios]:
            value = float(row["value"])
            self.assertTrue(math.isfinite(value) and value > 0, row)

    def test_ratios_follow_from_measurements_of_a_round(self):
        def value(what, round_number, precision):
            return next(float(row["value"]) for row in self.measurements
                        if (row["what"], row["size"], row["threads"]) == (what, "27000", "1")
                        and (row["round"], row["precision"]) == (round_number, precision))

        found = [row for row in self.ratios if row["what"] == "whole step: float over double"
                 and (row["size"], row["threads"]) == ("27000", "1")]
        self.assertEqual([row["round"] for row in found], ["0", "1"])
        for row in found:
            self.assertAlmostEqual(float(row["value"]),
                                   value("whole step", row["round"], "float") / value("whole step", row["round"], "double"))

    def test_table_has_a_row_for_each_series(self):
        wanted = {row["what"] for row in [*self.measurements, *self.ratios] if "nanoflann" not in row["what"]}
        self.assertLessEqual(wanted, {row["what"] for row in self.table})
        for row in self.table:
            self.assertEqual(row["rounds"], "2")
            self.assertLessEqual(float(row["min"]), float(row["lower_quartile"]))
            self.assertLessEqual(float(row["lower_quartile"]), float(row["upper_quartile"]))
            self.assertIn(row["what"], self.said)


if __name__ == "__main__":
    OUT = sys.argv.pop()
    unittest.main()
