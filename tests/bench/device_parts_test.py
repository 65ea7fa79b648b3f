"""What bench/device makes of the output of compilers and GPUs, on made-up ones, and the whole command where nvcc is."""

import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

BENCH = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench")
sys.path.insert(0, BENCH)

from device_parts import counted, measured, page

NVCC = shutil.which("nvcc") or "/usr/local/cuda/bin/nvcc"
ELEMENTS = ("void pinball::sum_pieces_of_range<pinball::ElementTotals<{0}>, pinball::UpdatesElements<{0}, "
            "pinball::ElementFeatures{{true, true, true, (pinball::HourglassKind)1, (pinball::YieldLaw)0, {1}, false}}>>(long)")
ASSEMBLER = """ptxas info    : Compiling entry function '{}' for 'sm_90'
ptxas info    : Function properties for it
    32 bytes stack frame, 52 bytes spill stores, 32 bytes spill loads
ptxas info    : Used {} registers, used 1 barriers
"""
STEPS = """copy: 4012 GB/s
double  viscous      216     198    1.000 s     2.000 G/s    812 B   40.5 % of the copy's rate   (energy 1.0e+00)
float   viscous      216     198    0.500 s     4.000 G/s    444 B   44.3 % of the copy's rate   (energy 1.0e+00)
"""


class Counted(unittest.TestCase):
    def test_registers_and_spills_of_kernels(self):
        said = "".join(ASSEMBLER.format(name, registers) for name, registers in
                       ((ELEMENTS.format("double", "false"), 250), (ELEMENTS.format("double", "true"), 255), ("void other<float>(int)", 10)))
        self.assertEqual(counted.kernels(said),
                         [{"what": "viscous", "precision": "double", "registers": 250, "spilled": 84},
                          {"what": "viscous, rare cases", "precision": "double", "registers": 255, "spilled": 84}])


class Measured(unittest.TestCase):
    def test_steps(self):
        found = measured.parse_steps(STEPS)
        self.assertEqual(found["copy"], 4012)
        self.assertEqual([row["rate"] for row in found["steps"]], [2e9, 4e9])
        self.assertRaisesRegex(ValueError, "did not print", measured.parse_steps, "copy: 1 GB/s\n")

    def test_page_keeps_both_kinds_apart(self):
        result = {"gpu": "H", "bandwidth": 4060.0, "kernels": [], "sanitizer": {"memcheck": "clean"}, "lulesh": 1e8,
                  "bytes": [{"what": "viscous", "precision": p, "bytes": b} for p, b in (("double", 812), ("float", 444))],
                  "hashes": {"block, double": False}, **measured.parse_steps(STEPS)}
        before, after = page.text(result).split("## Measured")
        self.assertIn("| 5.00 |", before)
        self.assertIn("| 2.000 | 40 % |", after)
        self.assertIn("20.0 times", after)
        self.assertIn("memcheck: clean", after)
        self.assertIn("block, double: OTHER BITS", after)


@unittest.skipUnless(os.path.exists(NVCC), "no nvcc")
class Command(unittest.TestCase):
    def test_counts_without_a_gpu(self):
        with tempfile.TemporaryDirectory() as out:
            done = subprocess.run([os.path.join(BENCH, "device"), "--nvcc", NVCC, "--out", out, "--sizes", "16"],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with open(os.path.join(out, "device.json"), encoding="utf-8") as file:
                result = json.load(file)
        self.assertEqual(len(result["bytes"]), 6)
        self.assertEqual(len(result["kernels"]), 14)  # of rare cases, too
        if not result["gpu"]:
            self.assertIn("Nothing: there is no GPU here.", done.stdout)

    def test_says_what_is_missing(self):
        with tempfile.TemporaryDirectory() as out:
            done = subprocess.run([os.path.join(BENCH, "device"), "--nvcc", "/none/nvcc", "--out", out], capture_output=True,
                                  text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("/none/nvcc", done.stderr)


if __name__ == "__main__":
    unittest.main()
