"""How bench/stress judges, on made-up runs; how it changes scenes: stress_parts_test.py."""

import glob
import math
import os
import sys
import tempfile
import unittest

import numpy as np

BENCH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench")
sys.path.insert(0, BENCH)

from stress_parts import case, folding, invariance, judge, page, program, random_scenes, scene
from stress_parts.judge import ACCURATE, CRASHES, HANGS, REFUSES, STOPS, UNCLEAR, WARNS, WRONG
from stress_parts.program import Run

FREE = scene.scene(1, [scene.elastic()], [scene.block("a", [1, 1, 1], [1, 1, 1])])
STOPPED = "pinball: error: the energy balance is off by 51 % at element 3 of body a in step 7 at time 1.5: the last good state is in x\n"


def ended(balance=0.0, momentum=(1.0, 0.0, 0.0), kinetic=1.0, warnings=(), **more):
    summary = {"energy": {"kinetic": kinetic, "initial_total": 1.0, "balance_error_max": balance}, "precision": "double", "end_time": 1.0,
               "momentum": {"initial": [1.0, 0.0, 0.0], "final": list(momentum)}, "warnings": list(warnings), "steps": 10,
               "bodies": [{"mass_initial": 2.0, "velocity": [0.0, 0.0, 0.0]}]}
    return Run(0, summary=summary, history={"kinetic": np.array([1.0, kinetic])}, **more)


def outcome(run, made=FREE, **more):
    return judge.judge(run, made, **more).outcome


class RunsThatEnd(unittest.TestCase):
    def test_sound(self):
        self.assertEqual(outcome(ended()), ACCURATE)

    def test_energy_out_of_balance(self):
        self.assertEqual(outcome(ended(balance=0.2)), WRONG)
        self.assertEqual(outcome(ended(balance=0.2, warnings=["the energy balance was off"])), WARNS)

    def test_momentum_drifts_only_where_nothing_acts_from_outside(self):
        self.assertEqual(outcome(ended(momentum=(1.0, 1e-6, 0.0))), WRONG)
        self.assertEqual(outcome(ended(momentum=(1.0, 1e-6, 0.0)), {**FREE, "rigid_wall": [{}]}), ACCURATE)

    def test_numbers_that_are_not_finite(self):
        run = ended()
        run.summary["energy"]["kinetic"] = None  # as NaN stands in summary.json
        self.assertEqual(outcome(run), WRONG)
        run = ended(kinetic=math.nan)
        self.assertEqual(outcome(run), WRONG)

    def test_no_results(self):
        self.assertEqual(outcome(Run(0)), WRONG)

    def test_figures_of_the_case(self):
        def figure(value):
            return lambda run: [judge.Figure("x", value, 1.0, 0.1)]
        self.assertEqual(outcome(ended(), figures=figure(1.05)), ACCURATE)
        self.assertEqual(outcome(ended(), figures=figure(1.2)), WRONG)
        self.assertEqual(outcome(ended(), figures=figure(math.nan)), WRONG)

    def test_text_is_of_the_worst_figure(self):
        verdict = judge.judge(ended(balance=0.01), FREE, lambda run: [judge.Figure("x", 1.09, 1.0, 0.1)])
        self.assertIn("x 1.09", verdict.text())


class RunsThatStop(unittest.TestCase):
    def stopped(self, said=STOPPED, last_good=True, steps=7):
        return Run(1, said, {"steps": steps}, last_good=last_good)

    def test_clearly(self):
        self.assertEqual(outcome(self.stopped()), STOPS)

    def test_without_the_last_good_state(self):
        self.assertEqual(outcome(self.stopped(last_good=False)), UNCLEAR)

    def test_without_saying_when(self):
        self.assertEqual(outcome(self.stopped("pinball: error: something is wrong\n")), UNCLEAR)

    def test_without_naming_the_element(self):
        self.assertEqual(outcome(self.stopped(), named=r"element \d+ of body"), STOPS)
        self.assertEqual(outcome(self.stopped(), named=r"node \d+"), UNCLEAR)

    def test_too_late(self):
        self.assertEqual(outcome(self.stopped(steps=301), most_steps=300), WRONG)
        self.assertEqual(outcome(self.stopped(steps=300), most_steps=300), STOPS)

    def test_what_nobody_foresaw(self):
        self.assertEqual(outcome(self.stopped("pinball: error: std::bad_alloc\n")), UNCLEAR)
        self.assertEqual(outcome(Run(2, "pinball: error: a.toml: vector::_M_default_append\n")), UNCLEAR)

    def test_bad_input(self):
        self.assertEqual(outcome(Run(2, "pinball: error: a.toml:3:4: time.end: expected a number > 0, got 0\n")), REFUSES)
        self.assertEqual(outcome(Run(2, "pinball: error: no\n")), UNCLEAR)

    def test_signals_other_statuses_and_time(self):
        self.assertEqual([outcome(Run(status)) for status in (-11, 3, None)], [CRASHES, CRASHES, HANGS])


class Rows(unittest.TestCase):
    def row(self, run, **more):
        real, program.run = program.run, lambda *_, **__: run
        try:
            return case.Case("group", "title", FREE, **more).row("folder")
        finally:
            program.run = real

    def test_right_is_what_is_expected(self):
        self.assertTrue(self.row(ended()).right)
        self.assertFalse(self.row(ended(), expected=(STOPS,)).right)
        self.assertFalse(self.row(Run(-6)).right)

    def test_scenes_at_random_that_differ_or_are_wrong_are_named(self):
        hashes = iter("aab" + "ccc" + "ddd")
        runs = {0: ended, 1: ended, 2: lambda: ended(balance=0.3)}
        real = program.run

        def fake(made, folder, threads=1):
            run = runs[int(os.path.basename(folder).split("_")[0])]()
            run.summary["state_hash"] = next(hashes)
            return run
        program.run = fake
        try:
            laws, bits = random_scenes.rows(3, "folder")
        finally:
            program.run = real
        self.assertFalse(laws.right)
        self.assertIn("seed 2", laws.text)
        self.assertFalse(bits.right)
        self.assertIn("[0]", bits.text)

    def test_scenes_with_elements_inside_out_are_named(self):
        def fake(made, folder, threads=1, timeout=0, arguments=()):
            run = ended()
            run.summary["inside_out"] = {"most": 2 if folder.endswith(("folding_3", "case_1")) else 0}
            return run
        real, program.run = program.run, fake
        try:
            rows = folding.rows("quick", "folder")
        finally:
            program.run = real
        self.assertEqual([row.right for row in rows], [True, False] + [True] * (len(rows) - 3) + [False])
        self.assertIn("seeds [3]", rows[-1].text)
        self.assertIn("inside out in any step 2", rows[1].text)

    def test_page_and_table_show_every_row(self):
        rows = [vars(self.row(ended())), {**vars(self.row(Run(-6))), "title": "<worse>"}]
        results = {"form": "quick", "machine": {"revision": "abc"}, "seconds": 1.0, "rows": rows}
        self.assertIn("&lt;worse&gt;", page.render(results))
        self.assertIn("| group: title | accurate |", page.markdown(results))
        self.assertIn("| **CRASHES** |", page.markdown(results))
        self.assertIn("2 rows, 1 wrong;", page.markdown(results))

    def test_kept_results_are_whole(self):
        kept = glob.glob(os.path.join(BENCH, "results", "*", "stress.md"))
        self.assertTrue(kept)
        for path in kept:
            with open(path, encoding="utf-8") as file:
                text = file.read()
            self.assertIn(f"\n{text.count(chr(10) + '| ') - 1} rows, 0 wrong;", text, path)  # but the names of the columns


class Scenes(unittest.TestCase):
    def test_toml(self):
        text = scene.toml({"title": "a \"b\"", "time": {"end": 0.1}, "body": [{"size": [1, 0.5], "mesh": {"type": "x"}, "on": True}]})
        self.assertEqual(text, 'title = "a \\"b\\""\n\n[time]\nend = 0.1\n\n[[body]]\nsize = [1, 0.5]\nmesh = { type = "x" }\non = true\n')

    def test_meshes_stand_beside_the_scene(self):
        body = {"name": "a", "material": "solid", "mesh": scene.hexahedron(*scene.CUBE)}
        with tempfile.TemporaryDirectory() as folder:
            with open(scene.write(scene.scene(1, [scene.elastic()], [body]), folder), encoding="utf-8") as file:
                self.assertIn('file = "scene_a.msh"', file.read())
            self.assertTrue(os.path.exists(os.path.join(folder, "scene_a.msh")))

    def test_scenes_at_random_are_the_same_every_time(self):
        self.assertEqual(scene.toml(random_scenes.random_scene(5)), scene.toml(random_scenes.random_scene(5)))
        self.assertNotEqual(scene.toml(random_scenes.random_scene(5)), scene.toml(random_scenes.random_scene(6)))


def volumes(mesh):
    """Of the elements, by the triple product at their first corner."""
    x = mesh.nodes[mesh.elements]
    return np.einsum("ij,ij->i", np.cross(x[:, 1] - x[:, 0], x[:, 3] - x[:, 0]), x[:, 4] - x[:, 0])


class Transformations(unittest.TestCase):
    def setUp(self):
        self.made = invariance.blocks({"method": "pinball"})

    def test_turned(self):
        other, rotation = invariance.turned(self.made, [0.3, -0.5, 0.8])
        np.testing.assert_allclose(rotation @ rotation.T, np.eye(3), atol=1e-14)
        np.testing.assert_allclose(rotation @ [0, 0, 1], np.array([0.3, -0.5, 0.8]) / math.sqrt(0.98), atol=1e-14)
        np.testing.assert_allclose(volumes(other["body"][0]["mesh"]), 1, rtol=1e-12)
        np.testing.assert_allclose(np.linalg.norm(other["body"][1]["velocity"]), np.linalg.norm(self.made["body"][1]["velocity"]))

    def test_mirrored_elements_are_not_inside_out(self):
        mesh = self.made["body"][0]["mesh"]
        np.testing.assert_allclose(volumes(scene.Hexahedra(mesh.nodes @ invariance.MIRROR,
                                                           mesh.elements[:, invariance.CORNERS_MIRRORED])), 1)

    def test_renumbered_is_the_same_mesh(self):
        mesh = self.made["body"][0]["mesh"]
        other = invariance.renumbered(mesh)
        np.testing.assert_allclose(volumes(other), 1)
        self.assertFalse(np.array_equal(other.elements, mesh.elements))
        centres = [sorted(map(tuple, m.nodes[m.elements].mean(axis=1).round(9))) for m in (mesh, other)]
        self.assertEqual(*centres)

    def test_units(self):
        other = invariance.in_units(self.made, 1000.0, 10.0, 7.0)  # from km, 10 s, 7 kg to m, s, kg
        self.assertAlmostEqual(other["material"][0]["density"], 7e-9)
        self.assertAlmostEqual(other["material"][0]["young_modulus"], 7 / 1000 / 100)
        self.assertEqual(other["time"]["end"], 10 * self.made["time"]["end"])
        self.assertAlmostEqual(other["body"][0]["velocity"][2], 100 * self.made["body"][0]["velocity"][2])


if __name__ == "__main__":
    unittest.main()
