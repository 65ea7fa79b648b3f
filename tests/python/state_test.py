"""States of the Python package: pickles and copies of simulations, checkpoints, probes. PYTHONPATH names the package's
folder, the first argument is the program."""

import copy
import json
import pathlib
import pickle
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import pinball

PROGRAM = sys.argv.pop(1)


def simulation_of(name, threads=0, **changes):
    return pinball.Simulation(pinball.read_scene(name, **changes), threads)


def end_of(simulation):
    simulation.run()
    return simulation.state_hash, simulation.steps, simulation.history_row()


def block_of_arrays(precision="double", **body):
    """A block in free flight and rotation, with its own forces."""
    z, y, x = np.meshgrid([-0.0, 0.3, 1.1], [-0.0, 1.0], np.linspace(0, 2, 4), indexing="ij")
    coordinates = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    first = np.array([k * 8 + i for k in range(2) for i in range(3)])
    corners = np.stack([first + offset for offset in (0, 1, 5, 4, 8, 9, 13, 12)], axis=1)
    scene = pinball.Scene(precision=precision)
    scene.time.end = 2.0
    scene.materials = [pinball.Material(name="m", density=1, bulk_modulus=100, shear_modulus=50)]
    scene.bodies = [pinball.Body(name=name, material="m", mesh=pinball.ArrayMesh(coordinates, corners), **{
        "position": [place, 0.1, 0], "angular_velocity": [0, 0.1, 0.2], "axis": [1, 2, 3], **body})
        for name, place in (("a", 0.0), ("b", 5.0))]
    return scene


class Pickles(unittest.TestCase):
    def expect_the_same_end(self, make, time):
        expected = end_of(make())
        simulation = make()
        simulation.run_until(time)
        copies = [pickle.loads(pickle.dumps(simulation)), copy.deepcopy(simulation)]
        for again in copies:
            self.assertEqual(again.state_hash, simulation.state_hash)
            self.assertEqual((again.time, again.steps, again.dt), (simulation.time, simulation.steps, simulation.dt))
            self.assertEqual(end_of(again), expected)
        self.assertLess(simulation.steps, expected[1])  # copies are apart
        self.assertEqual(end_of(simulation), expected)

    def test_of_scene_files_go_on_with_the_same_bits(self):
        for name, time in (("two_bars", 5.5), ("two_blocks", 3e-5), ("rod_plate", 3e-6)):
            changes = ["time.steps=150"] if name == "rod_plate" else []
            with self.subTest(name):
                self.expect_the_same_end(lambda: simulation_of(name, set=changes), time)

    def test_of_arrays_go_on_with_the_same_bits(self):
        for precision in ("double", "float", "mixed"):
            with self.subTest(precision):
                self.expect_the_same_end(lambda: pinball.Simulation(block_of_arrays(precision)), 0.7)

    def test_of_rigid_bodies_with_a_mass_go_on_with_the_same_bits(self):
        def make():
            scene = block_of_arrays()
            scene.rigid_bodies = [pinball.RigidBody(name="rigid", bodies=["a"], mass=3)]
            return pinball.Simulation(scene)

        self.expect_the_same_end(make, 0.7)
        self.assertEqual([material.name for material in make().scene.materials], ["m"])
        self.assertEqual([body.material for body in make().scene.bodies], ["m", "m"])

    def test_take_forces_of_the_host_with_them(self):
        def make():
            simulation = pinball.Simulation(block_of_arrays())
            simulation.external_forces()[:, 2] = 1e-3 * np.arange(simulation.nodes)
            return simulation

        self.assertNotEqual(end_of(make())[0], end_of(pinball.Simulation(block_of_arrays()))[0])
        self.expect_the_same_end(make, 0.7)

    def test_of_a_complete_run_are_complete(self):
        simulation = simulation_of("two_bars")
        simulation.run()
        again = pickle.loads(pickle.dumps(simulation))
        self.assertTrue(again.complete)
        self.assertFalse(again.step())
        self.assertEqual((again.state_hash, again.steps), (simulation.state_hash, simulation.steps))

    def test_keep_what_they_were_made_with(self):
        simulation = simulation_of("two_bars", threads=2)
        again = pickle.loads(pickle.dumps(simulation))
        self.assertEqual((again.threads, again.scene), (2, simulation.scene))
        self.assertEqual(repr(again), "<pinball.Simulation of two_bars: 20 elements, 0 steps, time 0.0 of 8.0>")

    def test_of_another_mesh_are_refused(self):
        state = simulation_of("two_bars").__getstate__()
        for change in ({"fingerprint": 1}, {"simd_width": 3}):
            again = pinball.Simulation.__new__(pinball.Simulation)
            with self.assertRaisesRegex(pinball.InputError, "pickled by pinball"):
                again.__setstate__({**state, **change})
        for state["state"] in (state["state"][:-8], state["state"] + b"12345678"):
            with self.assertRaisesRegex(pinball.InputError, "does not fit"):
                pinball.Simulation.__new__(pinball.Simulation).__setstate__(state)


class Checkpoints(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.file = str(pathlib.Path(self.folder.name) / "state.pinball")

    def summary_of_program(self, *arguments):
        out = pathlib.Path(self.folder.name) / "out"
        subprocess.run([PROGRAM, "run", *arguments, "--quiet", "--out", out], check=True, stdout=subprocess.DEVNULL)
        return json.loads((out / "summary.json").read_text())

    def test_go_on_here_and_in_the_program(self):
        expected = end_of(simulation_of("two_blocks"))
        simulation = simulation_of("two_blocks")
        simulation.run_until(3e-5)
        simulation.save_checkpoint(self.file)
        again = pinball.Simulation.from_checkpoint(self.file)
        self.assertEqual(again.steps, simulation.steps)
        self.assertEqual(end_of(again), expected)
        self.assertEqual(self.summary_of_program("--restart", self.file)["state_hash"], f"{expected[0]:016x}")

    def test_of_the_program_go_on_here(self):
        self.summary_of_program("two_blocks", "--checkpoint-every", "50", "--set", "time.steps=60")
        file = str(pathlib.Path(self.folder.name) / "out" / "checkpoint.pinball")
        again = pinball.Simulation.from_checkpoint(file, set=["time.steps=70"])
        self.assertEqual(again.steps, 60)
        again.run()
        self.assertEqual(again.state_hash, end_of(simulation_of("two_blocks", set=["time.steps=70"]))[0])

    def test_need_the_scene_of_a_file(self):
        changed = pinball.read_scene("two_bars")
        changed.time.end = 7
        for scene, message in ((block_of_arrays(), "expected a scene of a file"), (changed, "that was changed")):
            with self.assertRaisesRegex(pinball.InputError, message):
                pinball.Simulation(scene).save_checkpoint(self.file)
        simulation = simulation_of("two_bars")
        simulation.external_forces()[:] = 1
        with self.assertRaisesRegex(pinball.InputError, "expected no external forces"):
            simulation.save_checkpoint(self.file)
        self.assertFalse(pathlib.Path(self.file).exists())

    def test_that_are_damaged_are_refused(self):
        simulation_of("two_bars").save_checkpoint(self.file)
        content = bytearray(pathlib.Path(self.file).read_bytes())
        content[-1] ^= 1
        pathlib.Path(self.file).write_bytes(content)
        with self.assertRaisesRegex(pinball.InputError, "damaged"):
            pinball.Simulation.from_checkpoint(self.file)
        with self.assertRaisesRegex(pinball.InputError, "no such file"):
            pinball.Simulation.from_checkpoint(self.file + "x")
        with self.assertRaisesRegex(pinball.RunError, "cannot"):
            simulation_of("two_bars").save_checkpoint(self.folder.name + "/none/x.pinball")


class Probes(unittest.TestCase):
    def test_are_read_during_a_run(self):
        scene = pinball.read_scene("two_bars")
        scene.probes = [pinball.Probe(name="tip", kind="node", point=[10, 0, 0]),
                        pinball.Probe(name="middle", kind="element", point=[5.5, 0.5, 0.5], quantities=["stress"])]
        simulation = pinball.Simulation(scene)
        columns = simulation.history_columns()
        stresses = []

        def compare(s):
            tip, middle = s.probes
            row = s.history_row().more
            self.assertEqual(tip["velocity_x"], row[columns.index("tip_velocity_x")])
            self.assertEqual(middle["stress_xx"], row[columns.index("middle_stress_xx")])
            np.testing.assert_allclose(middle["stress_xx"], s.stress()[middle.number, 0])
            stresses.append(middle["stress_xx"])

        simulation.on_step(compare)
        simulation.run()
        self.assertLess(min(stresses), -0.3)  # the wave: density c v / 2 = 0.5
        tip, middle = simulation.probes
        self.assertEqual((tip.name, tip.body, tip.element, tip.number), ("tip", "bar1", False, 10))
        self.assertEqual((middle.element, list(middle.point)), (True, [5.5, 0.5, 0.5]))
        self.assertEqual(simulation.summary()["probes"][0]["values"]["velocity_x"], tip["velocity_x"])
        with self.assertRaises(KeyError):
            tip["stress_xx"]


if __name__ == "__main__":
    unittest.main()
