"""Recorded runs of the Python package, beside those of the program: runs_test.py PROGRAM"""

import csv
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

import pinball

PROGRAM = sys.argv.pop(1)


class Runs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_leave_the_files_of_the_program(self):
        settings = ["output.field_interval=1e-4"]
        subprocess.run([PROGRAM, "run", "two_blocks", "--quiet", "--out", self.folder / "program", "--set", *settings],
                       check=True, stdout=subprocess.DEVNULL)
        summary = pinball.run_recorded(pinball.read_scene("two_blocks", set=settings), str(self.folder / "python"))
        here, there = ({str(path.relative_to(self.folder / name)) for path in (self.folder / name).rglob("*")}
                       for name in ("python", "program"))
        self.assertEqual(here, there)
        self.assertIn("history.csv", here)
        texts = [(self.folder / name / "history.csv").read_text() for name in ("python", "program")]
        self.assertEqual(texts[0], texts[1])
        self.assertEqual(summary, json.loads((self.folder / "python" / "summary.json").read_text()))

    def test_go_on_from_their_checkpoint(self):
        expected = pinball.run_recorded(pinball.read_scene("two_blocks"), str(self.folder / "whole"))["state_hash"]
        first = pinball.read_scene("two_blocks", set=["time.steps=40"])
        pinball.run_recorded(first, str(self.folder / "part"), checkpoint_every=20)
        again = pinball.restart_recorded(str(self.folder / "part" / "checkpoint.pinball"), set=["time.steps=-1"])
        self.assertEqual(again["state_hash"], expected)
        rows = [(self.folder / name / "history.csv").read_text() for name in ("whole", "part")]
        self.assertEqual(rows[0].splitlines()[-1], rows[1].splitlines()[-1])

    def test_go_on_from_a_checkpoint_of_another_device(self):
        scene = pinball.read_scene("block", set=["time.steps=20"])
        scene.device = "mock"
        expected = pinball.run_recorded(scene, str(self.folder / "part"), checkpoint_every=10)
        self.assertEqual(expected["device"], "mock")
        checkpoint = str(self.folder / "part" / "checkpoint.pinball")
        self.assertEqual(pinball.Simulation.from_checkpoint(checkpoint, device="mock").scene.device, pinball.Device.mock)
        again = pinball.restart_recorded(checkpoint, set=["time.steps=21"])
        self.assertEqual((again["device"], again["steps"]), ("none", 21))

    def test_are_refused_where_there_is_no_such_device(self):
        scene, refused = pinball.read_scene("block"), 0
        for device in ("cuda", "hip"):
            scene.device = device
            try:
                pinball.Simulation(scene)
            except pinball.InputError as error:
                self.assertRegex(str(error), f"^device {device}: ")
                refused += 1
        self.assertGreaterEqual(refused, 1)  # no module is built for both

    def test_of_changed_scenes_have_no_checkpoints(self):
        scene = pinball.read_scene("two_blocks")
        scene.bodies[0].velocity = [1, 0, 0]
        with self.assertRaisesRegex(pinball.InputError, "needs the source"):
            pinball.run_recorded(scene, str(self.folder / "out"), checkpoint_every=20)

    def test_are_ended_by_an_interrupt_with_their_files(self):
        # The tests may be run with it ignored (nohup).
        self.addCleanup(signal.signal, signal.SIGINT, signal.signal(signal.SIGINT, signal.default_int_handler))
        scene = pinball.read_scene("rod_plate")
        out = self.folder / "out"

        def interrupt():
            while not (out / "history.csv").exists():
                time.sleep(0.01)
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=interrupt)
        thread.start()
        with self.assertRaises(KeyboardInterrupt):
            pinball.run_recorded(scene, str(out))
        thread.join()
        self.assertEqual(json.loads((out / "summary.json").read_text())["status"], "stopped")
        with open(out / "history.csv", newline="") as file:
            self.assertGreater(len(list(csv.DictReader(file))), 0)


if __name__ == "__main__":
    unittest.main()
