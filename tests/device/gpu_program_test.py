"""The program with kernels for a GPU: that it is made and runs, and what its kernels ask of a processor of the GPU.

    gpu_program_test.py CMAKE BUILD_FOLDER PROGRAM LOG_FOLDER [--fix]

LOG_FOLDER: what the assembler said of each source. registers.txt keeps it by kernel, for one release of nvcc: a kernel
that takes more registers than 8 above what stands there, or spills more bytes, has grown worse unseen. --fix writes
the file anew.
"""

import glob
import os
import re
import subprocess
import sys
import unittest

CMAKE, BUILD, PROGRAM, LOGS = sys.argv[1:5]
TABLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "registers.txt")
MORE_REGISTERS = 8  # they are given out by eights


def built():
    done = subprocess.run([CMAKE, "--build", BUILD, "--target", "pinball_with_gpu"], capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(done.stdout + done.stderr)


def kernels():
    """(registers, bytes spilled) by kernel; {} where a source was not compiled with what is asked of the assembler."""
    text = ""
    for path in sorted(glob.glob(os.path.join(LOGS, "*.log"))):
        with open(path) as log:
            text += log.read()
    text = subprocess.run(["c++filt"], input=text, capture_output=True, text=True, check=True).stdout
    found = {}
    for part in text.split("Compiling entry function '")[1:]:
        name = part.split("' for '")[0].replace("pinball::", "")
        name = re.sub(r"^void |\(long, .*$", "", name)
        spilled = sum(map(int, re.search(r"(\d+) bytes spill stores, (\d+) bytes spill loads", part).groups()))
        found[name] = int(re.search(r"Used (\d+) registers", part).group(1)), spilled
    return found


def release():
    with open(os.path.join(BUILD, "CMakeCache.txt")) as cache:
        nvcc = re.search(r"^CUDAToolkit_NVCC_EXECUTABLE:\w+=(.+)$", cache.read(), re.MULTILINE).group(1)
    said = subprocess.run([nvcc, "--version"], capture_output=True, text=True, check=True).stdout
    return re.search(r"release ([\d.]+)", said).group(1)


def written(found):
    lines = [f"nvcc {release()}, sm_90: registers, bytes of spills, kernel"]
    lines += [f"{registers:4d} {spilled:5d}  {name}" for name, (registers, spilled) in sorted(found.items())]
    return "\n".join(lines) + "\n"


def kept():
    """The release of nvcc, and registers and spills by kernel."""
    with open(TABLE) as table:
        head, *lines = table.read().splitlines()
    rows = (line.split(maxsplit=2) for line in lines)
    return head.split()[1].rstrip(","), {name: (int(registers), int(spilled)) for registers, spilled, name in rows}


class GpuProgram(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        built()

    def run_program(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True)

    def test_says_which_gpu_there_is_or_that_there_is_none(self):
        devices = self.run_program("info", "--device").stdout
        line = next(line for line in devices.splitlines() if line.strip().startswith("cuda:"))
        out = os.path.join(LOGS, "out")
        done = self.run_program("run", "block", "--device", "cuda", "--set", "time.steps=3", "--quiet", "--out", out)
        if "not there" in line:
            self.assertIn("no CUDA device was found", line)
            self.assertEqual(done.returncode, 2)
            self.assertIn("no CUDA device was found", done.stderr)
        else:
            self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_no_kernel_takes_more_than_it_did(self):
        known_release, known = kept()
        found = kernels()
        self.assertGreater(len(found), 80)
        if release() != known_release:
            self.skipTest(f"{TABLE} is of another release of nvcc")
        self.assertEqual(sorted(set(found) ^ set(known)), [], "kernels that came or went: --fix")
        worse = [f"{name}: {found[name]}, {known[name]} before" for name in found
                 if found[name][0] > known[name][0] + MORE_REGISTERS or found[name][1] > known[name][1]]
        self.assertEqual(worse, [])


if __name__ == "__main__":
    if "--fix" in sys.argv:
        built()
        with open(TABLE, "w") as table:
            table.write(written(kernels()))
    else:
        unittest.main(argv=sys.argv[:1])
