"""Threads and processes that use the Python package. PYTHONPATH names the package's folder."""

import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import unittest

import pinball

signal.signal(signal.SIGINT, signal.SIG_IGN)  # as after nohup: a test that sends it takes it back
LIMIT = 60  # s, beyond which something hangs


def simulation_of(name="two_blocks", threads=2):
    return pinball.Simulation(pinball.read_scene(name), threads)


def hash_of(threads):
    simulation = simulation_of(threads=threads)
    simulation.run()
    return simulation.state_hash


def in_child(function):
    """What a fork of this process answers: a text. Fails if it hangs or dies."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            os.write(writer, str(function()).encode())
        finally:
            os._exit(0)
    os.close(writer)
    end = time.monotonic() + LIMIT
    while time.monotonic() < end:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            answer = os.read(reader, 1000).decode()
            os.close(reader)
            return answer if status == 0 else f"status {status}"
        time.sleep(0.01)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    os.close(reader)
    return "hangs"


class OneSimulation(unittest.TestCase):
    def test_is_used_by_one_thread_at_a_time(self):
        simulation = simulation_of()
        wrong, refused = [], []

        def use():
            for attempt in range(10_000):
                try:
                    if not simulation.step():
                        return
                    simulation.history_row()
                    simulation.state_hash
                except RuntimeError as error:
                    refused.append(str(error))
                except BaseException as error:
                    wrong.append(error)
                    return

        threads = [threading.Thread(target=use) for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(LIMIT)
        self.assertEqual(wrong, [])
        self.assertTrue(all("is used by one thread at a time" in message for message in refused))
        simulation.run()
        self.assertEqual(simulation.state_hash, hash_of(1))

    def test_is_refused_to_others_while_it_runs(self):
        simulation = simulation_of()
        inside, go_on = threading.Event(), threading.Event()
        simulation.on_step(lambda s: inside.set() or go_on.wait(LIMIT))
        runner = threading.Thread(target=simulation.run)
        runner.start()
        self.assertTrue(inside.wait(LIMIT))
        uses = [simulation.run, simulation.step, lambda: simulation.run_until(1), lambda: simulation.positions,
                simulation.stress, lambda: simulation.time, lambda: simulation.bodies, simulation.summary,
                simulation.velocities_to_change, simulation.external_forces, lambda: simulation.on_step(print),
                lambda: pickle.dumps(simulation), lambda: repr(simulation), lambda: simulation.save_checkpoint("x"),
                lambda: simulation.nodes_of("a"), lambda: simulation.scene, lambda: simulation.probes]
        for use in uses:
            with self.assertRaisesRegex(RuntimeError, "one thread at a time"):
                use()
        go_on.set()
        runner.join(LIMIT)
        self.assertTrue(simulation.complete)
        self.assertEqual(simulation.state_hash, hash_of(1))

    def test_is_not_stepped_by_its_own_callback(self):
        simulation = simulation_of()
        simulation.on_step(lambda s: s.step())
        with self.assertRaisesRegex(RuntimeError, "callback of its own"):
            simulation.run()

    def test_is_stepped_by_one_thread_after_the_other(self):
        simulation = simulation_of()
        for end in (1e-5, 2e-5, 1.0):
            thread = threading.Thread(target=simulation.run_until, args=(end,))
            thread.start()
            thread.join(LIMIT)
        self.assertEqual(simulation.state_hash, hash_of(1))

    def test_lets_arrays_be_read_while_it_runs(self):
        simulation = simulation_of()
        x, v = simulation.positions, simulation.velocities
        runner = threading.Thread(target=simulation.run)
        runner.start()
        while runner.is_alive():
            self.assertEqual(x[:].shape, v[:].shape)
        del simulation
        runner.join()
        self.assertTrue((x[:] == x[:]).all())


class ManySimulations(unittest.TestCase):
    def test_run_side_by_side(self):
        expected, results = hash_of(1), []

        def run(threads):
            simulation = simulation_of(threads=threads)
            simulation.on_step(lambda s: s.time)
            simulation.run()
            results.append(simulation.state_hash)

        threads = [threading.Thread(target=run, args=(1 + n % 2,)) for n in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(LIMIT)
        self.assertEqual(results, [expected] * 8)


class Forks(unittest.TestCase):
    def test_after_a_run_make_runs(self):
        for used, wanted in ((2, 2), (2, 0), (0, 3), (1, 2)):
            expected = hash_of(used)
            self.assertEqual(in_child(lambda: hash_of(wanted)), str(expected), (used, wanted))

    def test_go_on_with_what_they_inherit(self):
        expected = hash_of(2)
        simulation = simulation_of(threads=2)
        simulation.run_until(3e-5)
        self.assertEqual(in_child(lambda: (simulation.run(), simulation.summary(), simulation.state_hash)[2]), str(expected))
        self.assertEqual(in_child(lambda: in_child(lambda: (simulation.run(), simulation.state_hash)[1])), str(expected))
        simulation.run()
        self.assertEqual(simulation.state_hash, expected)

    def test_change_velocities_and_pickle_in_a_child(self):
        def change(simulation):
            simulation.velocities_to_change()[:] *= 0.5
            again = pickle.loads(pickle.dumps(simulation))
            again.run()
            return again.state_hash

        simulation, other = simulation_of(threads=2), simulation_of(threads=2)
        simulation.run_until(3e-5)
        other.run_until(3e-5)
        self.assertEqual(in_child(lambda: change(simulation)), str(change(other)))

    def test_run_in_new_threads_of_a_child(self):
        expected, results = hash_of(2), []

        def run():
            threads = [threading.Thread(target=lambda: results.append(hash_of(2))) for _ in range(3)]
            for thread in threads:
                thread.start()
            for thread in threads:
                thread.join()
            return set(results)

        self.assertEqual(in_child(run), str({expected}))

    def test_of_a_pool_make_runs(self):
        expected = hash_of(2)
        with multiprocessing.get_context("fork").Pool(3) as pool:
            self.assertEqual(pool.map_async(hash_of, [0, 1, 2, 3]).get(LIMIT), [expected] * 4)

    def test_hand_simulations_on(self):
        expected = hash_of(2)
        with multiprocessing.get_context("fork").Pool(2) as pool:
            simulations = pool.map_async(half_run, [1, 2]).get(LIMIT)
        for simulation in simulations:
            simulation.run()
            self.assertEqual(simulation.state_hash, expected)


def half_run(threads):
    simulation = simulation_of(threads=threads)
    simulation.run_until(3e-5)
    return simulation


class Interrupts(unittest.TestCase):
    def setUp(self):  # the tests may be run with it ignored (nohup)
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))

    def test_end_a_run_between_two_steps(self):
        simulation = simulation_of()
        simulation.on_step(lambda s: os.kill(os.getpid(), signal.SIGINT) if s.steps == 10 else None)
        with self.assertRaises(KeyboardInterrupt):
            simulation.run()
        self.assertIn(simulation.steps, (10, 11))
        simulation.run()
        self.assertEqual(simulation.state_hash, hash_of(1))


class DaemonThreads(unittest.TestCase):
    """Threads that are still in a run when the interpreter ends: the program ends as if they had not been."""

    def ends_well(self, work, wait="time.sleep(0.2)"):
        script = ("import sys, tempfile, threading, time, pinball\n"
                  "scene = pinball.read_scene('rod_plate')\n"
                  f"def work():\n    {work}\n"
                  "for _ in range(2): threading.Thread(target=work, daemon=True).start()\n"
                  f"{wait}\nsys.exit(7)\n")
        ended = subprocess.run([sys.executable, "-c", script], timeout=LIMIT, capture_output=True, text=True)
        self.assertEqual((ended.returncode, ended.stderr), (7, ""), work)

    def test_in_a_run(self):
        self.ends_well("pinball.Simulation(scene).run()")

    def test_that_builds(self):
        self.ends_well("pinball.Simulation(scene)", wait="")

    def test_in_steps(self):
        self.ends_well("s = pinball.Simulation(scene)\n    while s.step(): pass")

    def test_in_a_callback(self):
        for callback in ("lambda s: time.sleep(0.001)", "lambda s: time.sleep(100)", "lambda s: sum(range(30000))"):
            self.ends_well(f"s = pinball.Simulation(scene); s.on_step({callback}); s.run()")

    def test_in_a_recorded_run(self):
        self.ends_well("pinball.run_recorded(scene, tempfile.mkdtemp())")


if __name__ == "__main__":
    unittest.main()
