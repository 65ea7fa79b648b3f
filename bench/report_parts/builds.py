"""The builds that are compared, and what their compilers and object files say."""

import json
import os
import re
import shlex
import shutil
import subprocess
import time

from . import machine_code, remarks
from .kernels import KERNELS

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BASE = "no-vectorization"  # one lane: what vectorization is compared with
NATIVE = "release"  # all that this processor has
PRESETS = [BASE, "avx2", NATIVE]  # those that are compared
TARGETS = ["pinball", "bench_kernels"]


class Failed(Exception):
    """What went wrong, in words for whoever ran the program."""


def leave_out(preset):
    """It is not built, nor compared."""
    PRESETS.remove(preset)


def folder(preset):
    return os.path.join(ROOT, "build", preset)


def program(preset, name="pinball"):
    return os.path.join(folder(preset), "bench" if name.startswith("bench") else "", name)


def run(command, **options):
    """stdout of a command; raises Failed with the end of what it said."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace", **options)
    except OSError as error:
        raise Failed(f"{command[0]}: {error.strerror}")
    if done.returncode != 0:
        raise Failed(f"{shlex.join(command)} ended with status {done.returncode}:\n"
                     + "\n".join((done.stdout + done.stderr).splitlines()[-20:]))
    return done.stdout


def check_tools():
    for tool, package in (("cmake", "cmake"), ("ninja", "ninja-build"), ("nm", "binutils"), ("objdump", "binutils")):
        if shutil.which(tool) is None:
            raise Failed(f"{tool} is needed and not there (Debian: package {package})")


def knows(preset, targets):
    """Whether a preset is configured with these targets: ./run configures without benchmarks."""
    try:
        with open(os.path.join(folder(preset), "build.ninja"), encoding="utf-8") as file:
            text = file.read()
    except FileNotFoundError:
        return False
    return all(f"\nbuild {target}: " in text for target in targets)


def build(preset, targets=TARGETS):
    """Configures where that has not been done, builds what is needed; returns the seconds that it took."""
    start = time.monotonic()
    if not knows(preset, targets):
        with_ccache = not os.path.exists(os.path.join(folder(preset), "build.ninja")) and shutil.which("ccache")
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if with_ccache else []
        # Without tests there is no mock device: minutes less. The preset alone has them again.
        without = ["-DPINBALL_TESTS=OFF", "-DPINBALL_PYTHON=OFF"] if preset != NATIVE else []
        run(["cmake", "--preset", preset, *without, *launcher], cwd=ROOT)
    run(["cmake", "--build", "--preset", preset, "--target", *targets], cwd=ROOT)
    return time.monotonic() - start


def compile_commands(preset):
    """{object file: (folder, source, arguments)} of the library."""
    with open(os.path.join(folder(preset), "compile_commands.json"), encoding="utf-8") as file:
        entries = json.load(file)
    found = {}
    for entry in entries:
        arguments = shlex.split(entry["command"])
        if os.path.basename(arguments[0]) == "ccache":
            arguments = arguments[1:]
        target = arguments[arguments.index("-o") + 1]
        if re.search(r"pinball_(contact|solver)(_api)?_objects\.dir/.*\.o$", target):
            found[os.path.join(entry["directory"], target)] = (entry["directory"], entry["file"], arguments)
    return found


def flags(preset):
    """The flags that decide what code is generated, of the contact and of the element kernels."""
    kept = {}
    for target, (_, source, arguments) in compile_commands(preset).items():
        name = os.path.basename(source)
        if name in ("unity_contact_pinball_cxx.cxx", "pinball_algorithm.cpp", "tile_kernels_double.cpp"):
            kept[name] = " ".join(a for a in arguments[1:] if re.match(r"-(O|m|f(?!PIC)|std|DNDEBUG|DPINBALL_SIMD)", a))
    return kept


def function_names(*options):
    """What `nm` with these options, among them object files, says that they define."""
    rows = [line.split(" ", 2) for line in run(["nm", "--defined-only", *options]).splitlines()]
    return [row[2] for row in rows if len(row) == 3]


def objects_of_kernels(preset):
    """{object file: names of functions} for all kernels of the table."""
    patterns = [re.compile(p) for kernel in KERNELS for p in kernel.symbols]
    found = {}
    for target in compile_commands(preset):
        names = function_names("-C", target)
        if any(p.search(name) for name in names for p in patterns):
            found[target] = names
    return found


def disassemble(path, lines=False):
    options = ["-l"] if lines else []
    with subprocess.Popen(["objdump", "-d", "-C", "--no-show-raw-insn", *options, path], stdout=subprocess.PIPE, text=True,
                          errors="replace") as process:
        functions = machine_code.parse_objdump(process.stdout)
    if process.returncode != 0:
        raise Failed(f"objdump could not read {path}")
    return functions


def code_of_kernels(preset):
    """{kernel: (names, Counts)} from the object files of the library."""
    functions = {}
    for path in objects_of_kernels(preset):
        for name, counts in disassemble(path).items():
            functions.setdefault(name, counts)
    code = {}
    for kernel in KERNELS:
        names, counts = machine_code.select(functions, kernel.symbols)
        if not names:
            raise Failed(f"no function of build/{preset} is the kernel \"{kernel.title}\" "
                         f"(bench/report_parts/kernels.py: {kernel.symbols[0]})")
        code[kernel.key] = (names, counts)
    return code


def newer(path, *others):
    return os.path.exists(path) and all(os.path.getmtime(path) >= os.path.getmtime(other) for other in others)


def compile_again(preset, path, compiler, options, out):
    """Compiles the source of an object file once more with further options, unless `out` is newer than the object.

    compiler: None for that of the build."""
    if newer(out, path):
        return
    directory, _, (own_compiler, *arguments) = compile_commands(preset)[path]
    arguments = [a for a in arguments if a not in ("-Werror", "-Winvalid-pch")]
    while "-include" in arguments:  # precompiled headers, which are of the build's own compiler and options
        at = arguments.index("-include")
        del arguments[at:at + 2]
    arguments[arguments.index("-o") + 1] = out + ".part.o"
    run([compiler or own_compiler, *arguments, "-w", *options], cwd=directory)
    os.replace(out + ".part.o", out)


def compiler_of(preset):
    return next(iter(compile_commands(preset).values()))[2][0]


def is_gcc(preset):
    return "Free Software Foundation" in run([compiler_of(preset), "--version"])


def remarks_of_compiler(preset):
    """({kernel: Counts with source lines}, {kernel: Remarks}) of the compiler of a build; no remarks if it is not gcc."""
    where = os.path.join(folder(preset), "remarks")
    os.makedirs(where, exist_ok=True)
    with_gcc = is_gcc(preset)
    counts = {kernel.key: machine_code.Counts() for kernel in KERNELS}
    said = {kernel.key: remarks.Remarks() for kernel in KERNELS}
    seen = set()  # functions that stand in several object files
    for path in objects_of_kernels(preset):
        name = os.path.basename(path).split(".")[0]
        out, text = os.path.join(where, name + ".o"), os.path.join(where, name + ".txt")
        compile_again(preset, path, None, ["-g1", *([f"-fopt-info-vec-all={text}"] if with_gcc else [])], out)
        functions = {symbol: c for symbol, c in disassemble(out, lines=True).items() if symbol not in seen}
        seen.update(functions)
        for kernel in KERNELS:
            names, found = machine_code.select(functions, kernel.symbols)
            counts[kernel.key] += found
            if names and with_gcc:
                with open(text, encoding="utf-8", errors="replace") as file:
                    said[kernel.key].add(remarks.parse_gcc(file, found.lines))
    return counts, said if with_gcc else None


def clang_remarks(preset):
    """{kernel: Remarks} of clang++ with the flags of the build; None where it is not installed."""
    compiler = shutil.which("clang++")
    if compiler is None:
        return None
    where = os.path.join(folder(preset), "remarks")
    os.makedirs(where, exist_ok=True)
    said = {kernel.key: remarks.Remarks() for kernel in KERNELS}
    for path in objects_of_kernels(preset):
        name = os.path.basename(path).split(".")[0]
        out, text = os.path.join(where, name + ".clang.o"), os.path.join(where, name + ".yaml")
        # Without its own OpenMP library clang takes the serial backend: the same loops.
        compile_again(preset, path, compiler, ["-fno-openmp", "-gline-tables-only", f"-foptimization-record-file={text}",
                                               "-foptimization-record-passes=loop-vectorize|slp-vectorizer"], out)
        for kernel in KERNELS:
            with open(text, encoding="utf-8", errors="replace") as file:
                said[kernel.key].add(remarks.parse_clang(file, kernel.mangled))
    return said
