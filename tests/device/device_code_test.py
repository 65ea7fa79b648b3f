"""Kernels as device code: every function marked for a device is compiled for one, and none loses its code there.

    device_code_test.py COMPILER HOST_COMPILER SOURCE_FOLDER WORK_FOLDER CLASS

COMPILER: nvcc. A compiler of device code may only warn of a host function in a kernel and leave the kernel empty; so
warnings are errors, and the PTX of each kernel has to write something.
"""

import os
import re
import subprocess
import sys
import unittest

NVCC, HOST, SOURCE, WORK = sys.argv[1:5]
SOURCES = {name: os.path.join(SOURCE, "tests/device", name + ".cu") for name in ["kernels", "exec"]}
SOLVER = {"boundary_kernels_gpu": os.path.join(SOURCE, "solver/boundary/space/boundary_kernels_gpu.cu"),
          "bench_device": os.path.join(SOURCE, "bench/bench_device.cu")}  # whole steps, with few of their kernels
ARCHITECTURES = ([], ["-arch=sm_90"])  # the compiler's default, and an H200

DROPPED = """
__host__ __device__ inline int lowest(unsigned bits) { return __builtin_ctz(bits); }
__global__ void planted(const unsigned* bits, int* number) { number[threadIdx.x] = lowest(bits[threadIdx.x]); }
"""


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout


def compiled(source, *options, name):
    """The PTX of a source."""
    out = os.path.join(WORK, name + ".ptx")
    run(NVCC, "-std=c++20", "-ccbin", HOST, f"-I{SOURCE}", f"-I{WORK}", *options, "-ptx", source, "-o", out)
    with open(out) as ptx:
        return ptx.read()


def kernels(ptx):
    """Names of the kernels and their bodies."""
    return re.findall(r"\.entry\s+(\w+)\s*\([^)]*\)[^{]*(\{.*?\n\})", ptx, re.DOTALL)


def kernels_that_write_nothing(ptx):
    return [name for name, body in kernels(ptx) if not re.search(r"\b(st|red|atom)\.global", body)]


def base_name(function):
    """`touching_pairs` of "unsigned pinball::touching_pairs<double>(double const*)"."""
    function = re.sub(r"\{lambda\([^()]*\)#\d+\}", "lambda", function)
    operator = re.search(r"operator\s*([^\w\s(<]+|<)", function)
    if operator:
        return operator.group(0)
    without_templates = function
    while "<" in without_templates and (shorter := re.sub(r"<[^<>]*>", "", without_templates)) != without_templates:
        without_templates = shorter
    return re.search(r"(\w+)\s*\(", without_templates).group(1)


def toolkit_headers():
    """The folder of CUDA's headers, as nvcc tells it: what is called may be a script that stands in another folder."""
    said = subprocess.run([NVCC, "--dryrun", SOURCES["exec"]], capture_output=True, text=True).stderr
    return os.path.join(re.search(r"^#\$ TOP=(.+)$", said, re.MULTILINE).group(1), "include")


def marked_functions():
    """Names of all functions that are marked for a device, as its compiler sees the headers."""
    text = run(HOST, "-std=c++20", "-E", "-P", "-x", "c++", "-D__CUDACC__", "-DPINBALL_FUNCTION=MARKED_FUNCTION",
               "-DPINBALL_OUTLINED=MARKED_FUNCTION", f"-I{SOURCE}", f"-I{WORK}", "-I" + toolkit_headers(),
               os.path.join(WORK, "kernel_headers.hpp"))
    heads = re.findall(r"MARKED_FUNCTION\b(.*?)[{;]", text, re.DOTALL)
    return {base_name(" ".join(head.split()) + ("" if "(" in head else "(")) for head in heads}


class DeviceCode(unittest.TestCase):
    def test_compiles_without_a_warning(self):
        for architecture in ARCHITECTURES:
            for name, source in (SOURCES | SOLVER).items():
                run(NVCC, "-std=c++20", "-ccbin", HOST, "-Werror", "all-warnings", *architecture, f"-I{SOURCE}",
                    f"-I{WORK}", "-c", source, "-o", os.path.join(WORK, name + ".o"))

    def test_no_kernel_is_empty(self):
        for architecture in ARCHITECTURES:
            for name, least in [("kernels", 20), ("exec", 5), ("boundary_kernels_gpu", 30)]:
                ptx = compiled((SOURCES | SOLVER)[name], *architecture, name=name)
                self.assertGreater(len(kernels(ptx)), least)
                self.assertEqual(kernels_that_write_nothing(ptx), [])

    def test_a_kernel_that_lost_its_code_is_found(self):
        planted = os.path.join(WORK, "planted.cu")
        with open(planted, "w") as file:
            file.write(DROPPED)
        self.assertEqual(len(kernels_that_write_nothing(compiled(planted, name="planted"))), 1)


class MarkedFunctions(unittest.TestCase):
    def test_each_is_compiled(self):
        # Not optimised and not inlined: each function by itself.
        functions = set()
        for name, source in SOURCES.items():
            ptx = compiled(source, "-arch=sm_90", "-G", "-DPINBALL_FUNCTION=__host__ __device__ __noinline__",
                           name=name + "_apart")
            symbols = set(re.findall(r"\.func\s+(?:\([^)]*\)\s*)?(\w+)", ptx))
            names = run("c++filt", *sorted(symbols)).splitlines()
            functions |= {base_name(name) for name in names if "(" in name}
        self.assertEqual(sorted(marked_functions() - functions), [])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], sys.argv[5]])
