"""The Python module: PYTHONPATH names its folder, the first argument is the program."""

import gc
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import threading
import unittest
import weakref

import numpy as np
import pinball

PROGRAM = sys.argv.pop(1)
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def bar_arrays(index=np.int32):
    """The mesh of the scene two_bars: ten elements of size 1 along x, nodes numbered along x, y, z."""
    z, y, x = np.meshgrid([0.0, 1.0], [0.0, 1.0], np.arange(11.0), indexing="ij")
    coordinates = np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1)
    first = np.arange(10)
    corners = [first + offset for offset in (0, 1, 12, 11, 22, 23, 34, 33)]
    return coordinates, np.stack(corners, axis=1).astype(index)


def two_bars(index=np.int32):
    scene = pinball.Scene()
    scene.time.end = 8.0
    scene.contact = pinball.ContactSettings(method="pinball", enforcement="penalty", beta=3.0, self=False,
                                            radius_factor=0.8059959770082347)
    scene.materials = [pinball.Material(name="bar", density=1, bulk_modulus=100 / 3, shear_modulus=50)]
    for name, start, speed in (("bar1", 0.0, 0.1), ("bar2", 10.5, 0.0)):
        scene.bodies.append(pinball.Body(name=name, material="bar", mesh=pinball.ArrayMesh(*bar_arrays(index)),
                                         position=[start, 0, 0], velocity=[speed, 0, 0]))
    scene.symmetry_planes = [pinball.SymmetryPlane(normal=[0, 1, 0]), pinball.SymmetryPlane(normal=[0, 0, 1]),
                             pinball.SymmetryPlane(point=[0, 1, 0], normal=[0, 1, 0]),
                             pinball.SymmetryPlane(point=[0, 0, 1], normal=[0, 0, 1])]
    return scene


class TwoBars(unittest.TestCase):
    def test_arrays_give_the_exact_velocities(self):
        # With steps of h/c, without viscosity and at small strains a wave moves by one element per step, so that the
        # bodies have their exact velocities: 0.05 of the contact per unit of time, from 5 to 7.
        speed = 1e-9
        scene = two_bars()
        scene.contact = pinball.ContactSettings(method="pinball", self=False)
        scene.element.bulk_viscosity = False
        scene.time.cfl = 1.001
        scene.bodies[0].position, scene.bodies[0].velocity = [-10, 0, 0], [speed, 0, 0]
        scene.bodies[1].position = [5 * speed, 0, 0]
        simulation = pinball.Simulation(scene)
        errors = []

        def compare(s):
            middle = s.state_time if s.complete else s.state_time + s.dt / 2  # velocities are half a step ahead
            exact = np.clip((middle - 5) / 2, 0, 1)
            velocities = np.array([body.velocity[0] for body in s.bodies]) / speed
            errors.append(np.abs(velocities - [1 - exact, exact]).max())

        simulation.on_step(compare)
        self.assertTrue(simulation.run())
        self.assertEqual(simulation.steps, 80)
        self.assertLess(max(errors), 1e-6)

    def test_scene_file_gives_the_bits_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([PROGRAM, "run", "two_bars", "--out", folder, "--quiet"], check=True,
                           stdout=subprocess.DEVNULL)
            written = json.loads((pathlib.Path(folder) / "summary.json").read_text())
        simulation = pinball.Simulation(pinball.read_scene("two_bars"), threads=1)
        simulation.run()
        summary = simulation.summary()
        for key in ("state_hash", "steps", "energy", "momentum", "bodies", "contact"):
            self.assertEqual(summary[key], written[key], key)
        self.assertEqual(f"{simulation.state_hash:016x}", written["state_hash"])

    def test_arrays_give_the_bits_of_the_scene_file(self):
        hashes = set()
        for index in (None, np.int32, np.int64):
            scene = pinball.read_scene("two_bars")
            if index:
                for body in scene.bodies:
                    body.mesh = pinball.ArrayMesh(*bar_arrays(index))
            simulation = pinball.Simulation(scene)
            simulation.run()
            hashes.add(simulation.state_hash)
        self.assertEqual(len(hashes), 1)


class Arrays(unittest.TestCase):
    def setUp(self):
        self.simulation = pinball.Simulation(two_bars())

    def test_views_are_the_memory_of_the_solver(self):
        s = self.simulation
        x, v = s.positions, s.velocities
        self.assertEqual(x.shape, (88, 3))
        self.assertTrue(np.shares_memory(x, s.positions))
        node = s.place_of_node[0]
        self.assertEqual(x[node, 0], 0)
        s.step()
        self.assertEqual(x[node, 0], s.dt * v[node, 0])
        self.assertTrue(np.shares_memory(x, s.positions))
        self.assertFalse(x.flags.writeable)
        self.assertAlmostEqual(s.masses.sum(), 20)

    def test_orders_are_joined_by_places(self):
        s = self.simulation
        coordinates, _ = bar_arrays()
        of_bar2 = s.nodes_of("bar2")
        np.testing.assert_array_equal(s.positions[s.place_of_node[of_bar2]], coordinates + [10.5, 0, 0])
        np.testing.assert_array_equal(s.position()[of_bar2], coordinates + [10.5, 0, 0])
        self.assertEqual(s.elements_of("bar2"), slice(10, 20, 1))

    def test_writing_velocities_moves_nodes(self):
        s = self.simulation
        s.velocities_to_change()[:, 0] += 1
        self.assertAlmostEqual(s.velocities[s.place_of_node[0], 0], 1.1)
        s.step()
        self.assertAlmostEqual(s.history_row().momentum[0], 21)

    def test_external_forces_accelerate(self):
        s = self.simulation
        s.external_forces()[:, 0] = s.masses * 2
        s.run_until(1.0)
        for body, before in zip(s.bodies, (0.1, 0.0)):  # velocities are half a step behind
            self.assertAlmostEqual(body.velocity[0], before + 2 * (s.time - s.dt / 2), delta=1e-9)

    def test_wrong_calls_are_named(self):
        with self.assertRaisesRegex(pinball.InputError, "run_until: expected a time, got nan"):
            self.simulation.run_until(np.nan)
        with self.assertRaisesRegex(pinball.InputError, "threads: expected an integer"):
            pinball.Simulation(pinball.read_scene("two_bars"), threads=2**31 - 1)

    def test_copies_fill_arrays_of_the_caller(self):
        s = self.simulation
        s.run_until(5.5)
        stress = np.full((40, 6), np.nan, dtype=np.float32)[::2]
        self.assertIs(s.stress(out=stress), stress)
        np.testing.assert_array_equal(stress, s.stress().astype(np.float32))
        self.assertLess(stress[:, 0].min(), -0.4)  # the exact stress is density c v / 2 = 0.5
        np.testing.assert_array_equal(s.plastic_strain(), np.zeros(20))

    def test_float_precision(self):
        scene = two_bars()
        scene.precision = "float"
        self.assertEqual(pinball.Simulation(scene).positions.dtype, np.float32)


class Lifetimes(unittest.TestCase):
    def test_an_array_keeps_its_simulation(self):
        simulation = pinball.Simulation(two_bars())
        gone = weakref.ref(simulation)
        x = simulation.positions
        expected = x.copy()
        del simulation
        gc.collect()
        self.assertIsNotNone(gone())
        np.testing.assert_array_equal(x, expected)
        del x
        gc.collect()
        self.assertIsNone(gone())

    def test_a_mesh_keeps_its_arrays_until_it_goes(self):
        coordinates, hexahedra = bar_arrays()
        gone = weakref.ref(coordinates)
        scene = two_bars()
        scene.bodies[0].mesh = pinball.ArrayMesh(coordinates, hexahedra)
        del coordinates
        gc.collect()
        self.assertIsNotNone(gone())
        simulation = pinball.Simulation(scene)
        del scene
        gc.collect()
        self.assertIsNone(gone())
        self.assertEqual(simulation.nodes, 88)


class Callbacks(unittest.TestCase):
    def test_are_called_after_each_step_and_at_the_end(self):
        simulation = pinball.Simulation(two_bars())
        seen = []
        simulation.on_step(lambda s: seen.append((s is simulation, s.steps)))
        simulation.run()
        self.assertEqual([step for _, step in seen], [*range(1, simulation.steps + 1), simulation.steps])
        self.assertTrue(all(same for same, _ in seen))

    def test_stop_a_run_by_false(self):
        simulation = pinball.Simulation(two_bars())
        simulation.on_step(lambda s: s.steps < 3)
        self.assertFalse(simulation.run())
        self.assertEqual(simulation.steps, 3)
        self.assertFalse(simulation.complete)

    def test_exceptions_pass(self):
        simulation = pinball.Simulation(two_bars())
        simulation.on_step(lambda s: {}["missing"])
        with self.assertRaisesRegex(KeyError, "missing"):
            simulation.run()
        self.assertEqual(simulation.steps, 1)


class Threads(unittest.TestCase):
    def test_two_simulations_give_the_bits_of_one_after_the_other(self):
        simulations = [pinball.Simulation(two_bars(), threads=count) for count in (1, 1, 2)]
        threads = [threading.Thread(target=s.run) for s in simulations[:2]]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        simulations[2].run()
        self.assertEqual(len({s.state_hash for s in simulations}), 1)


class Errors(unittest.TestCase):
    def expect(self, message, change):
        scene = two_bars()
        coordinates, hexahedra = bar_arrays()
        with self.assertRaises(pinball.InputError) as caught:
            change(scene, coordinates, hexahedra)
            scene.bodies[0].mesh = pinball.ArrayMesh(coordinates, hexahedra)
            pinball.Simulation(scene)
        self.assertIsInstance(caught.exception, ValueError)
        self.assertEqual(str(caught.exception), message)

    def test_name_the_argument(self):
        def nan(scene, coordinates, hexahedra):
            coordinates[3, 2] = np.nan

        def index(scene, coordinates, hexahedra):
            hexahedra[4, 0] = 44

        def density(scene, coordinates, hexahedra):
            scene.materials[0].density = -1

        self.expect("body.bar1.mesh.coordinates[3][2]: expected a finite number, got nan", nan)
        self.expect("body.bar1.mesh.hexahedra[4][0]: expected a node from 0 to 43, got 44", index)
        self.expect("material.bar.density: expected a number > 0, got -1", density)

    def test_of_arrays(self):
        coordinates, hexahedra = bar_arrays()
        simulation = pinball.Simulation(two_bars())
        for message, call in [
            ("hexahedra: expected numbers of float32, float64, int32 or int64, got uint8",
             lambda: pinball.ArrayMesh(coordinates, hexahedra.astype(np.uint8))),
            ("coordinates: expected one or two axes, got 3",
             lambda: pinball.ArrayMesh(coordinates[None], hexahedra)),
            ("copy: to: expected 20 records of 6, got 19 of 6", lambda: simulation.stress(out=np.zeros((19, 6)))),
            ("out: expected an array that can be written", lambda: simulation.position(out=simulation.positions)),
        ]:
            with self.assertRaises(pinball.InputError) as caught:
                call()
            self.assertEqual(str(caught.exception), message)

    def test_unknown_names(self):
        with self.assertRaises(AttributeError):
            pinball.Material(densty=1)
        with self.assertRaisesRegex(ValueError, "ContactMethod: unknown value"):
            pinball.ContactMethod("pinbal")


class Example(unittest.TestCase):
    def test_plots_a_history_in_ten_lines(self):
        example = ROOT / "python" / "examples" / "two_bars_history.py"
        lines = [line for line in example.read_text().splitlines() if line and not line.startswith("#")]
        self.assertLessEqual(len(lines), 10)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, example], cwd=folder, check=True, env={**os.environ, "MPLBACKEND": "Agg"})
            self.assertGreater((pathlib.Path(folder) / "two_bars.png").stat().st_size, 5000)


if __name__ == "__main__":
    unittest.main()
