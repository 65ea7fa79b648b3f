"""What bench/speed makes of measurements, on made-up ones: speed_parts_test.py."""

import csv
import glob
import json
import os
import sys
import tempfile
import unittest

import numpy as np

BENCH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench")
sys.path.insert(0, BENCH)

from report_parts import measuring
from speed_parts import contact, published, samples, scenes, shuffled_mesh, table, whole_steps
from speed_parts.samples import Log, Ratio


def log_of(*rounds):
    """A log with a list of (what, size, precision, threads, value) for each round."""
    log = Log("AVX2")
    for log.round, measured in enumerate(rounds):
        for *series, value in measured:
            log.add(*series, value, "1/s")
    return log


class Spread(unittest.TestCase):
    def test_quartiles(self):
        self.assertEqual(measuring.spread([4.0, 1.0, 2.0, 5.0, 3.0]),
                         {"median": 3, "min": 1, "max": 5, "lower_quartile": 2, "upper_quartile": 4})

    def test_one_value_is_all_of_them(self):
        self.assertEqual(set(measuring.spread([7.0]).values()), {7.0})


class InstructionSets(unittest.TestCase):
    def test_by_the_width_of_the_packs(self):
        self.assertEqual([samples.instruction_set(*packs) for packs in ((8, "double"), (8, "float"), (2, "double"), (1, "float"))],
                         ["AVX-512", "AVX2", "SSE2", "one lane"])


class Ratios(unittest.TestCase):
    def test_only_within_a_round_and_with_all_else_alike(self):
        log = log_of([("a", 1, "double", 1, 6.0), ("b", 1, "double", 1, 2.0), ("a", 1, "float", 1, 7.0), ("a", 2, "double", 1, 8.0)],
                     [("a", 1, "double", 1, 5.0), ("b", 1, "double", 2, 2.0)])
        found = samples.ratios(log.samples, Ratio("a over b", {"what": "a"}, {"what": "b"}))
        self.assertEqual([(r.what, r.value, r.unit, r.round) for r in found], [("a over b", 3.0, "ratio", 0)])

    def test_costs_are_the_inverse_of_rates(self):
        log = log_of([("a", 1, "double", 1, 6.0), ("a", 8, "double", 1, 4.0), ("a", 8, "float", 1, 4.0)])
        found = samples.ratios(log.samples, Ratio("cost", {"what": "a"}, {"what": "a", "size": 1}, inverse=True))
        self.assertEqual([(r.size, r.value) for r in found], [(8, 1.5)])

    def test_of_whole_steps(self):
        step, small, large = whole_steps.STEP, 27_000, 216_000
        log = log_of([(step, small, "double", 1, 10.0), (step, small, "double", 2, 18.0), (step, large, "double", 1, 8.0),
                      (step, large, "float", 1, 12.0), (whole_steps.LULESH, large, "double", 1, 2.0)])
        found = {definition.what: [r.value for r in samples.ratios(log.samples, definition)]
                 for definition in whole_steps.ratios(log.samples)}
        self.assertEqual(list(found.values()), [[1.5], [1.8], [1.25], [4.0]])


class Reading(unittest.TestCase):
    def setUp(self):
        self.log = Log("AVX-512")

    def values(self):
        return {(s.what, s.size, s.precision, s.threads): s.value for s in self.log.samples}

    def test_names_of_benchmarks(self):
        self.assertEqual(measuring.parts_of("stages/pinball/per_side:236/threads:1/iterations:42/real_time"),
                         (["stages", "pinball"], {"per_side": 236, "threads": 1, "iterations": 42}))

    def test_whole_steps(self):
        context = {"triad_GB_per_s_1_threads": "15.0", "triad_GB_per_s_2_threads": "29.2", "peak_GFLOP_per_s_1_threads": "83.5",
                   "peak_GFLOP_per_s_2_threads": "157.0"}
        names = ["whole_steps<double>/per_side:60/threads:2/real_time", "whole_steps<float>/per_side:60/threads:1/real_time"]
        whole_steps.read({"context": context, "benchmarks": [{"name": name, "element_steps": 8e6, "of_bandwidth": 0.25}
                                                             for name in names]}, self.log)
        self.assertEqual(self.values(), {
            (whole_steps.STEP, 216_000, "double", 2): 8.0, (whole_steps.PART, 216_000, "double", 2): 0.25,
            ("memory bandwidth (triad)", 216_000, "double", 2): 29.2, ("arithmetic peak", 216_000, "double", 2): 157.0,
            (whole_steps.STEP, 216_000, "float", 1): 8.0, (whole_steps.PART, 216_000, "float", 1): 0.25})

    def test_lulesh_counts_thousands(self):
        self.assertAlmostEqual(whole_steps.lulesh_rate(
            "Elapsed time         =        2.6 (s)\nGrind time (us/z/c)  =  2.4390685 (per dom)  (  2.634194 overall)\n"
            "FOM                  =  409.99258 (z/s)\n\n"), 0.40999258)
        with self.assertRaises(whole_steps.Failed):
            whole_steps.lulesh_rate("")

    def test_scene(self):
        phases = dict.fromkeys((t for timers in measuring.STAGES.values() for t in timers), 0.0)
        phases.update(internal_forces=0.5, contact_search=0.125, contact_forces=0.125)
        summary = {"elements": 1842, "precision": "double", "threads": 2, "wall_seconds": 1.0, "phase_seconds": phases,
                   "element_steps_per_second": 3e6, "steps": 100, "element_steps": 92100}
        scenes.read(scenes.CASES[0], summary, self.log)
        self.assertEqual([(s.what, s.value) for s in self.log.samples],
                         [("rod_plate: time", 1.0), ("rod_plate: share of contact", 0.25),
                          ("rod_plate: contact in a step", 2.5), ("rod_plate: speed", 3.0),
                          ("rod_plate: part that is worked", 0.5)])

    def test_scene_that_is_cut_short_has_no_time(self):
        phases = dict.fromkeys((t for timers in measuring.STAGES.values() for t in timers), 0.0)
        summary = {"elements": 9, "precision": "double", "threads": 1, "wall_seconds": 1.0, "phase_seconds": phases,
                   "element_steps_per_second": 3e6, "steps": 9, "element_steps": 81}
        scenes.read(scenes.Case("bar", "taylor_bar", steps=9), summary, self.log)
        self.assertEqual([s.what for s in self.log.samples], ["bar: speed", "bar: part that is worked"])

    def test_contact(self):
        contact.read({"benchmarks": [
            {"name": "list_from_nothing/close_packed/per_side:30/threads:1/real_time", "pinballs": 27000.0, "per_pinball": 5e-7},
            {"name": "list_by_nanoflann/close_packed/per_side:30/threads:1/leaf:10/real_time", "pinballs": 27000.0,
             "per_pinball": 1e-6},
            {"name": "forces/facing_layers/per_side:707/threads:2/real_time", "pinballs": 999698.0, "per_pair": 1e-7},
            {"name": "forces_of_tenth/close_packed/per_side:30/threads:1/real_time", "pinballs": 27000.0, "per_pair": 1e-8},
        ]}, self.log)
        for sample, (what, size, value) in zip(self.log.samples, [
                ("list from nothing, close-packed", 27_000, 500), ("pairs by nanoflann, leaf 10, close-packed", 27_000, 1000),
                ("contact forces, facing layers", 999_698, 100),
                ("contact forces, a tenth in contact, close-packed", 27_000, 10)]):
            self.assertEqual((sample.what, sample.size), (what, size))
            self.assertAlmostEqual(sample.value, value)


class Opponent(unittest.TestCase):
    def test_its_best_leaf_is_the_one_compared(self):
        def leaf(n, threads, value):
            return (contact.what_of(contact.LIBRARY, "close-packed", n), 27_000, "double", threads, value)

        ours = (contact.what_of(contact.OURS, "close-packed"), 27_000, "double")
        log = log_of([leaf(10, 1, 4.0), leaf(20, 1, 3.0), leaf(10, 2, 2.0), leaf(20, 2, 2.5), (*ours, 1, 1.5), (*ours, 2, 1.0)],
                     [leaf(10, 1, 4.0), leaf(20, 1, 3.0), leaf(10, 2, 2.0), leaf(20, 2, 2.5), (*ours, 1, 1.5), (*ours, 2, 1.0)])
        slower = contact.slower_leaves(log.samples)
        self.assertEqual({(series[0].split(", ")[1], series[3]) for series in slower}, {("leaf 10", 1), ("leaf 20", 2)})
        shown = [s for s in log.samples if s.series not in slower]
        found = [(r.threads, r.value) for definition in contact.ratios(shown) for r in samples.ratios(shown, definition)
                 if "nanoflann" in definition.what]
        self.assertEqual(sorted(found), [(1, 2.0), (1, 2.0), (2, 2.0), (2, 2.0)])


class Published(unittest.TestCase):
    def test_beside_the_same_mesh_in_double_precision_only(self):
        what = scenes.time_of("rod_plate")
        figure = published.figure_for(what, 1_842, "double", 1)
        self.assertEqual((figure.low, figure.high), (0.66, 0.66))
        for series in ((what, 1_842, "float", 1), (what, 14_736, "double", 1), (what, 1_842, "double", 4)):
            self.assertIsNone(published.figure_for(*series))

    def test_gain_of_times_and_of_rates(self):
        time = published.Figure("t", 1, 2.0, 3.0, "", 1, smaller_is_better=True)
        rate = published.Figure("r", 1, 2.0, 4.0, "", 1)
        self.assertEqual((time.gain(0.5), rate.gain(8.0)), ((4.0, 6.0), (2.0, 4.0)))

    def test_every_figure_belongs_to_something_that_is_measured(self):
        of_scenes = (scenes.time_of, scenes.speed_of, scenes.contact_time_of)
        measured = {whole_steps.STEP, *(f(case.title) for case in scenes.CASES for f in of_scenes)}
        self.assertLessEqual({figure.what for figure in published.FIGURES}, measured)


class Table(unittest.TestCase):
    SAMPLES = log_of([(scenes.time_of("rod_plate"), 1_842, "double", 1, 0.2), ("other", 5, "float", 2, 1234.5)],
                     [("other", 5, "float", 2, 1236.5), (scenes.time_of("rod_plate"), 1_842, "double", 1, 0.4)]).samples

    def test_a_row_for_each_series(self):
        first, second = table.rows(self.SAMPLES)
        self.assertEqual(first[:7], ["rod_plate: time", 1842, "double", 1, "AVX2", "1/s", 2])
        for value, expected in zip(first[7:11], (0.3, 0.2, 0.25, 0.35)):
            self.assertAlmostEqual(value, expected)
        self.assertEqual(first[11:], ["0.66", "2.2"])
        self.assertEqual(second[7:], [1235.5, 1234.5, 1235.0, 1236.0, "", ""])

    def test_columns_of_the_text_are_aligned(self):
        head, *lines = table.text(table.rows(self.SAMPLES)).splitlines()
        self.assertEqual(len(lines), 2)
        end = head.index("median") + len("median")
        self.assertEqual([line[:end].split()[-1] for line in lines], ["0.3", "1,236"])

    def test_files(self):
        with tempfile.TemporaryDirectory() as where:
            table.write(self.SAMPLES, [], self.SAMPLES, where)
            self.assertEqual(set(os.listdir(where)), set(table.FILES))
            with open(os.path.join(where, "measurements.csv"), newline="", encoding="utf-8") as file:
                rows = list(csv.DictReader(file))
        self.assertEqual(list(rows[0]), ["what", "size", "precision", "threads", "instruction_set", "value", "unit", "round"])
        self.assertEqual([(row["value"], row["round"]) for row in rows], [("0.2", "0"), ("1234.5", "0"), ("1236.5", "1"), ("0.4", "1")])

    def test_sources_once(self):
        self.assertEqual(table.sources(table.rows(self.SAMPLES)), [published.RADIOSS_ROD])

    def test_markdown_is_made_of_the_file(self):
        with tempfile.TemporaryDirectory() as where:
            table.write(self.SAMPLES, [], self.SAMPLES, where)
            read = table.read(where)
        self.assertEqual(read, table.rows(self.SAMPLES))
        machine = dict.fromkeys(("cpu", "cores", "memory_gib", "compiler", "revision", "load_average"), "x")
        self.assertIn("| rod_plate: time | 1,842 | double | 1 | AVX2 | 1/s | 2 | 0.3 | 0.2 | 0.25 | 0.35 | 0.66 | 2.2 |\n",
                      table.markdown(machine, read))

    def test_kept_results_are_those_of_their_files(self):
        kept = glob.glob(os.path.join(BENCH, "results", "*", "speed.md"))
        self.assertTrue(kept)
        for path in kept:
            where = os.path.dirname(path)
            with open(path, encoding="utf-8") as file, open(os.path.join(where, "machine.json"), encoding="utf-8") as machine:
                self.assertEqual(file.read(), table.markdown(json.load(machine), table.read(where)) + "\n", path)


class ShuffledMesh(unittest.TestCase):
    def test_output_is_no_part_of_a_step(self):
        log = Log("AVX2")
        shuffled_mesh.read("block", {"elements": 1000, "precision": "double", "threads": 1, "steps": 100, "wall_seconds": 0.3,
                                     "phase_seconds": {"output": 0.1}}, log)
        self.assertAlmostEqual(log.samples[0].value, 0.5)

    def test_elements_are_cubes(self):
        nodes, elements = shuffled_mesh.block(3)
        self.assertEqual((nodes.shape, elements.shape), ((64, 3), (27, 8)))
        unit = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]])
        np.testing.assert_allclose(3 * (nodes[elements] - nodes[elements[:, :1]]), np.broadcast_to(unit, (27, 8, 3)), atol=1e-12)

    def test_shuffling_moves_numbers_and_nothing_else(self):
        nodes, elements = shuffled_mesh.block(3)
        moved, corners = shuffled_mesh.shuffle(nodes, elements)
        self.assertFalse(np.array_equal(moved, nodes))
        self.assertFalse(np.array_equal(corners, elements))
        places = [sorted(map(tuple, n[e].reshape(len(e), -1).tolist())) for n, e in ((nodes, elements), (moved, corners))]
        self.assertEqual(*places)
        np.testing.assert_array_equal(corners, shuffled_mesh.shuffle(nodes, elements)[1])

    def test_file(self):
        with tempfile.TemporaryDirectory() as where:
            path = os.path.join(where, "mesh.msh")
            shuffled_mesh.write_gmsh(path, *shuffled_mesh.block(1))
            with open(path, encoding="ascii") as file:
                lines = file.read().splitlines()
        self.assertEqual(lines[3:6], ["$Nodes", "8", "1 0.0 0.0 0.0"])
        self.assertEqual(lines[-4:], ["$Elements", "1", "1 5 2 1 1 1 2 4 3 5 6 8 7", "$EndElements"])


if __name__ == "__main__":
    unittest.main()
