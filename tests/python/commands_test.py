"""pinball.run and pinball.compare: commands_test.py PROGRAM"""

import json
import pathlib
import sys
import tempfile
import unittest

import numpy as np

import pinball

PROGRAM = sys.argv.pop(1)
DECKS = pathlib.Path(__file__).resolve().parents[2] / "data" / "decks"


class Commands(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_run_leaves_the_files_of_a_run(self):
        settings = ["output.field_interval=0", "output.field_times=[0, 1e-4]", "time.end=1e-4"]
        summary = pinball.run("two_blocks", self.folder / "out", set=settings, threads=1, program=PROGRAM)
        self.assertEqual(summary, json.loads((self.folder / "out" / "summary.json").read_text()))
        expected = pinball.Simulation(pinball.read_scene("two_blocks", set=["time.end=1e-4"]))
        expected.run()
        self.assertEqual(summary["state_hash"], f"{expected.state_hash:016x}")
        self.assertEqual(len(pinball.read_fields(self.folder / "out").times), 2)
        self.assertTrue(pinball.view(self.folder / "out").page)

    def test_run_takes_decks(self):
        summary = pinball.run(DECKS / "wall.k", self.folder / "deck", program=PROGRAM)
        mass, speed = summary["bodies"][0]["mass_initial"], 10
        history = pinball.read_history(self.folder / "deck")
        (impulse,) = [name for name in history if name.endswith("_impulse")]
        self.assertAlmostEqual(history[impulse][-1], 2 * mass * speed, delta=0.025 * 2 * mass * speed)
        with self.assertRaisesRegex(pinball.InputError, "cases.k"):
            pinball.run(DECKS / "cases.k", self.folder / "case", case=77, program=PROGRAM)

    def test_run_says_why_it_fails(self):
        with self.assertRaisesRegex(pinball.RunError, "^the energy balance is off"):
            pinball.run("two_blocks", self.folder / "out", set=["guard.energy_error=1e-12"], program=PROGRAM)
        with self.assertRaisesRegex(pinball.InputError, "^(?!pinball: error).*no_such_scene"):
            pinball.run("no_such_scene", self.folder / "out", program=PROGRAM)
        with self.assertRaisesRegex(pinball.InputError, "precision"):
            pinball.run("two_blocks", self.folder / "out", precision="half", program=PROGRAM)

    def test_compare_returns_what_the_variants_took_and_gave(self):
        comparison = pinball.compare("two_blocks", {"contact.beta": [0.5, 1], "element.bulk_viscosity": [False, True]}, repeat=2, threads=1,
                                     set=["time.steps=60"], page=self.folder / "compare.html", program=PROGRAM)
        self.assertEqual(comparison.settings, [{"contact.beta": beta, "element.bulk_viscosity": viscosity}
                                               for beta in ("0.5", "1") for viscosity in ("false", "true")])
        self.assertEqual(comparison.all_seconds.shape, (4, 2))
        np.testing.assert_allclose(comparison.seconds, np.median(comparison.all_seconds, axis=1))
        self.assertTrue((comparison.contact_seconds < comparison.seconds).all())
        self.assertEqual(comparison.failures, [""] * 4)
        for settings, summary in zip(comparison.settings, comparison.summaries, strict=True):
            expected = pinball.Simulation(pinball.read_scene("two_blocks", set=["time.steps=60", *(f"{k}={v}" for k, v in settings.items())]))
            expected.run()
            self.assertEqual(summary["state_hash"], f"{expected.state_hash:016x}")
        self.assertIn("viewer_alone", pinball.view(self.folder / "compare.html").page)

    def test_compare_names_variants_that_fail(self):
        comparison = pinball.compare("two_blocks", {"guard.energy_error": [0.5, 1e-12]}, repeat=1, program=PROGRAM)
        self.assertEqual(comparison.failures[0], "")
        self.assertIn("energy balance", comparison.failures[1])
        with self.assertRaisesRegex(pinball.InputError, "contact.bta"):
            pinball.compare("two_blocks", {"contact.bta": [1]}, program=PROGRAM)


if __name__ == "__main__":
    unittest.main()
