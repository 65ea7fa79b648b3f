"""Results of a run's folder as arrays, as pandas and xarray: results_test.py PROGRAM"""

import csv
import importlib.util
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import pinball

PROGRAM = sys.argv.pop(1)
SETTINGS = ["time.end=2e-5", "output.field_times=[0, 1e-5, 2e-5]", "output.interval=1e-6"]


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name) / "out"
        subprocess.run([PROGRAM, "run", "rod_plate", "--quiet", "--threads", "1", "--out", cls.folder,
                        *(word for setting in SETTINGS for word in ("--set", setting))], check=True, stdout=subprocess.DEVNULL)
        cls.simulation = pinball.Simulation(pinball.read_scene("rod_plate", set=SETTINGS), threads=1)
        cls.simulation.run()

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def test_history_is_that_of_the_file(self):
        history = pinball.read_history(self.folder)
        with open(self.folder / "history.csv", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(list(history), list(rows[0]))
        self.assertEqual(len(history["time"]), 21)
        for name, values in history.items():
            self.assertEqual(values.tolist(), [float(row[name]) for row in rows])
        self.assertEqual(history.units["energy"], "lbf in")
        self.assertNotIn("columns", repr(history))

    def test_fields_are_those_of_the_run(self):
        fields = pinball.read_fields(str(self.folder))
        np.testing.assert_allclose(fields.times, [0, 1e-5, 2e-5], rtol=0, atol=1e-7)  # each at the end of a step
        self.assertEqual(fields.bodies, ["rod", "plate"])
        self.assertEqual(fields.hexahedra.shape, (1842, 8))
        self.assertEqual(fields.positions.shape[::2], (3, 3))
        s = self.simulation
        np.testing.assert_allclose(fields.positions[0], s.initial_position(), rtol=1e-6, atol=1e-6)
        np.testing.assert_allclose(fields.positions[-1], s.position(), rtol=1e-6, atol=1e-6)
        np.testing.assert_allclose(fields.of_nodes["velocity"][-1], s.velocity(), rtol=1e-5, atol=1e-2)
        np.testing.assert_allclose(fields.of_elements["plastic_strain"][-1], s.plastic_strain(), rtol=1e-6, atol=1e-9)
        self.assertEqual(fields.of_elements["stress"].shape, (3, 1842, 6))
        np.testing.assert_allclose(fields.of_elements["stress"][-1], s.stress(), rtol=1e-5, atol=1)
        self.assertEqual(fields.components["velocity"], ["x", "y", "z"])
        self.assertEqual(np.flatnonzero(fields.of_elements["body"][0] == 1).tolist(), list(range(1842))[s.elements_of("plate")])

    @unittest.skipUnless(importlib.util.find_spec("pandas"), "pandas is not there")
    def test_history_as_pandas(self):
        history = pinball.read_history(self.folder)
        frame = history.to_pandas()
        self.assertEqual(frame.index.name, "time")
        self.assertEqual(list(frame.columns), [name for name in history if name != "time"])
        np.testing.assert_array_equal(frame["kinetic"].to_numpy(), history["kinetic"])
        np.testing.assert_array_equal(frame.index.to_numpy(), history["time"])
        self.assertEqual(frame.attrs["units"], history.units)

    @unittest.skipUnless(importlib.util.find_spec("xarray"), "xarray is not there")
    def test_fields_as_xarray(self):
        fields = pinball.read_fields(self.folder)
        data = fields.to_xarray()
        self.assertEqual(dict(data.sizes), {"time": 3, "node": fields.positions.shape[1], "axis": 3, "element": 1842, "corner": 8,
                                            "stress_component": 6})
        self.assertEqual(set(data.data_vars), {"position", "hexahedra", *fields.of_nodes, *fields.of_elements})
        np.testing.assert_array_equal(data["stress"].sel(time=2e-5, stress_component="zz"), fields.of_elements["stress"][-1, :, 2])
        np.testing.assert_array_equal(data["position"].sel(axis="z").isel(time=0), fields.positions[0, :, 2])
        self.assertEqual(json.loads(data.attrs["units"])["stress"], "psi")

    def test_says_what_is_not_there(self):
        with self.assertRaisesRegex(pinball.InputError, r"^read_history: .*none/history.csv \(No such file"):
            pinball.read_history(self.folder / "none")
        with self.assertRaisesRegex(pinball.InputError, "^read_fields: .*none/fields.pvd: cannot be read"):
            pinball.read_fields(self.folder / "none")
        broken = self.folder.parent
        (broken / "history.csv").write_text("time,dt\n0,1\n1\n")
        with self.assertRaisesRegex(pinball.InputError, "a row is cut off.*expected the history"):
            pinball.read_history(broken)
        for name, size in (("fields.pvd", None), ("fields_0000.vtu", 2000), ("fields_0001.vtu", None), ("fields_0002.vtu", None)):
            (broken / name).write_bytes((self.folder / name).read_bytes()[:size])
        with self.assertRaisesRegex(pinball.InputError, "^read_fields: .*fields_0000.vtu"):
            pinball.read_fields(broken)


if __name__ == "__main__":
    unittest.main()
