"""pinball.converge: converge_test.py PROGRAM"""

import inspect
import json
import pathlib
import subprocess
import sys
import tempfile
import typing
import unittest

import numpy as np

import pinball

PROGRAM = sys.argv.pop(1)
OPTIONS = {"of": ["energy.kinetic", "upper_velocity_z"], "meshes": "1/2,1,2", "only": ["step", "chance"], "ensemble": 2, "threads": 1}


class Converge(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def converge(self, scene="two_blocks", **changes):
        return pinball.converge(scene, program=PROGRAM, out=self.folder / "out", **{**OPTIONS, **changes})

    def test_returns_what_the_program_writes_as_arrays(self):
        study = self.converge()
        file = self.folder / "table.json"
        subprocess.run([PROGRAM, "converge", "two_blocks", "--quiet", "--of", "energy.kinetic", "--of", "upper_velocity_z", "--meshes",
                        "1/2,1,2", "--only", "step", "--only", "chance", "--ensemble", "2", "--threads", "1", "--out", self.folder / "out",
                        "--json", file], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        table = json.loads(file.read_text())
        self.assertTrue(all(mesh["was_there"] for mesh in table["meshes"]), "the same runs")
        self.assertEqual(study.scene, "two_blocks")
        self.assertEqual(study.names, ["energy.kinetic", "upper_velocity_z"])
        self.assertEqual(study.units, ["J", "m/s"])
        np.testing.assert_array_equal(study.factors, [0.5, 1, 2])
        np.testing.assert_array_equal(study.elements, [16, 128, 1024])
        self.assertEqual(study.values.shape, (2, 3))
        self.assertEqual(study.errors.shape, (2, 3 + 1 + 2))
        for i, quantity in enumerate(table["quantities"]):
            np.testing.assert_array_equal(study.values[i], quantity["values"])
            self.assertEqual(study.verdicts[i], quantity["verdict"])
            np.testing.assert_equal(study.together[i], np.nan if quantity["together"] is None else quantity["together"])
            if quantity["band"] is None:
                self.assertTrue(np.isnan(study.bands[i]).all() and np.isnan(study.extrapolated[i]) and np.isnan(study.errors[i]).all())
            else:
                np.testing.assert_array_equal(study.bands[i], quantity["band"])
                np.testing.assert_allclose(study.errors[i][:3], abs(study.values[i] / study.extrapolated[i] - 1), rtol=1e-9)
        self.assertEqual(set(study.moved_by), {"mesh", "time step", "chance"})
        np.testing.assert_array_equal(study.value("upper_velocity_z"), study.values[1])
        self.assertRaises(KeyError, study.value, "lower_velocity_z")

    def test_runs_that_fail_are_named(self):
        study = self.converge(only=["mesh"], set=["guard.energy_error=1e-12"])
        self.assertEqual(len(study.failures), 3)
        self.assertIn("energy balance", study.failures[0])
        self.assertEqual(study.values.shape, (0, 3))

    def test_bad_input_is_an_error_that_says_what(self):
        with self.assertRaisesRegex(pinball.InputError, "^--meshes 1,2: expected three"):
            self.converge(meshes="1,2")
        with self.assertRaisesRegex(pinball.InputError, "no_such_scene"):
            self.converge("no_such_scene")
        with self.assertRaises((OSError, pinball.RunError)):
            pinball.converge("two_blocks", program="/no/such/program")

    def test_has_types(self):
        hints = typing.get_type_hints(pinball.converge)
        self.assertEqual(set(hints), set(inspect.signature(pinball.converge).parameters) | {"return"})
        self.assertIs(hints["return"], pinball.Convergence)
        self.assertTrue((pathlib.Path(pinball.__file__).parent / "py.typed").exists())


if __name__ == "__main__":
    unittest.main()
