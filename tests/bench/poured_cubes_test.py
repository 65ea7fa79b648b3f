"""The scene of poured cubes runs, and its impulses converge: without friction in all steps, with it in 99 of 100.

    poured_cubes_test.py PROGRAM FOLDER
"""

import json
import pathlib
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
PROGRAM, FOLDER = (pathlib.Path(a).resolve() for a in sys.argv[1:3])


class PouredCubes(unittest.TestCase):
    def contact(self, name, *options):
        FOLDER.mkdir(parents=True, exist_ok=True)
        scene = FOLDER / f"{name}.toml"
        with open(scene, "w") as file:
            subprocess.run([sys.executable, ROOT / "bench" / "poured_cubes", *options], stdout=file, check=True)
        subprocess.run([PROGRAM, "run", scene, "--out", FOLDER / name, "--threads", "1", "--quiet"], check=True, capture_output=True)
        summary = json.loads((FOLDER / name / "summary.json").read_text())
        self.assertLess(summary["energy"]["balance_error_max"], 0.01)
        self.assertGreater(summary["contact"]["solves"], 200)
        self.assertGreater(summary["contact"]["pairs_max"], 20)
        return summary["contact"]

    def test_converge_where_they_fall_flat(self):
        contact = self.contact("flat", "3", "3", "--steps", "400", "--tilt", "0")
        self.assertEqual(contact["unconverged"], 0)
        self.assertLess(contact["residual_share_max"], 1e-8)

    def test_converge_where_they_are_tilted(self):
        contact = self.contact("tilted", "3", "3", "--steps", "400")
        self.assertEqual(contact["unconverged"], 0)
        self.assertLess(contact["residual_share_max"], 1e-8)

    def test_converge_with_friction(self):
        contact = self.contact("rubbing", "3", "3", "--steps", "400", "--friction", "0.3")
        self.assertLessEqual(contact["unconverged"], 0.01 * contact["solves"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
